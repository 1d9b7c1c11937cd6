// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPartialOrder_h
#define vtkOITPartialOrder_h

#include <cstddef>
#include <vector>

/// Things, numbered from 0, of which it is known for some pairs which one comes first.
class vtkOITPartialOrder
{
public:
  using Numbers = std::vector<std::size_t>;

  /// What is done before the next things: some in an order, then others all at once.
  struct Batch
  {
    std::vector<Numbers> Levels;
    Numbers AtOnce;
  };

  explicit vtkOITPartialOrder(std::size_t count)
    : After(count)
    , CountBefore(count, 0)
    , IsAtOnce(count, false)
  {
  }

  /// At once with other such things, even with some that come before it.
  void SetAtOnce(std::size_t thing) { this->IsAtOnce[thing] = true; }

  void SetBefore(std::size_t first, std::size_t second)
  {
    this->After[first].push_back(second);
    ++this->CountBefore[second];
  }

  /// Each thing is on a higher level than all that come before it, on the lowest level that can be.
  /// Nothing when there is no such order, because some come before themselves.
  std::vector<Numbers> FindLevels() const;

  /// Each thing is in the first batch that it can be in. Nothing as above.
  std::vector<Batch> FindBatches() const;

private:
  std::vector<Numbers> After; // of each
  std::vector<int> CountBefore;
  std::vector<bool> IsAtOnce;
};

#endif
