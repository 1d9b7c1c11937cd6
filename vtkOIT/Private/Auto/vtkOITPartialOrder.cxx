// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITPartialOrder.h"

#include <utility>

//------------------------------------------------------------------------------
std::vector<vtkOITPartialOrder::Numbers> vtkOITPartialOrder::FindLevels() const
{
  std::vector<int> left = this->CountBefore;
  std::vector<Numbers> levels;
  Numbers next;
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    if (left[i] == 0)
    {
      next.push_back(i);
    }
  }
  std::size_t placed = 0;
  while (!next.empty())
  {
    Numbers after;
    for (const std::size_t i : next)
    {
      for (const std::size_t j : this->After[i])
      {
        if (--left[j] == 0)
        {
          after.push_back(j);
        }
      }
    }
    placed += next.size();
    levels.push_back(std::move(next));
    next = std::move(after);
  }
  return placed == left.size() ? levels : std::vector<Numbers>();
}
