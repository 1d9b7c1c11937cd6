// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDisjointSets_h
#define vtkOITDisjointSets_h

#include <cstddef>
#include <numeric>
#include <vector>

/// Things, numbered from 0, each in a set of its own until sets are united.
class vtkOITDisjointSets
{
public:
  explicit vtkOITDisjointSets(std::size_t count)
    : Parents(count)
    , NumberOfSets(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), std::size_t(0));
  }

  /// The one that stands for all of its set.
  std::size_t Find(std::size_t i)
  {
    while (this->Parents[i] != i)
    {
      i = this->Parents[i] = this->Parents[this->Parents[i]];
    }
    return i;
  }

  /// That of `a` stands for both.
  void Unite(std::size_t a, std::size_t b)
  {
    const std::size_t first = this->Find(a);
    const std::size_t second = this->Find(b);
    if (first != second)
    {
      this->Parents[second] = first;
      --this->NumberOfSets;
    }
  }

  std::size_t GetNumberOfSets() const { return this->NumberOfSets; }

private:
  std::vector<std::size_t> Parents;
  std::size_t NumberOfSets;
};

#endif
