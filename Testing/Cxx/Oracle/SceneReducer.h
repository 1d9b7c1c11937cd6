// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Makes a failing case small: removes items as long as what is left still fails (delta debugging,
 * Zeller and Hildebrandt 2002, without their tests of subsets alone).
 */

#ifndef SceneReducer_h
#define SceneReducer_h

#include <algorithm>
#include <functional>
#include <vector>

namespace vtkOITTest
{
/// Items, in their order, that still fail, and of which none can be removed without ending that.
/// `fails` must be true for the given items; otherwise they are returned as they are.
template <typename Item>
std::vector<Item> Reduce(
  std::vector<Item> items, const std::function<bool(const std::vector<Item>&)>& fails)
{
  if (!fails(items))
  {
    return items;
  }
  std::size_t size = std::max<std::size_t>(items.size() / 2, 1); // of the part that is removed
  while (!items.empty())
  {
    bool isSmaller = false;
    for (std::size_t start = 0; start < items.size();)
    {
      std::vector<Item> rest(items.begin(), items.begin() + start);
      rest.insert(rest.end(), items.begin() + std::min(start + size, items.size()), items.end());
      if (fails(rest))
      {
        items = rest; // what follows has moved to start
        isSmaller = true;
      }
      else
      {
        start += size;
      }
    }
    if (size > 1)
    {
      size /= 2;
    }
    else if (!isSmaller)
    {
      break;
    }
  }
  return items;
}
}

#endif
