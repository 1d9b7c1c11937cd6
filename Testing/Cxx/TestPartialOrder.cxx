// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Levels of things of which some come before others: each on the lowest that can be.

#include "Rig/Report.h"

#include "Private/Auto/vtkOITPartialOrder.h"

#include <string>
#include <utility>
#include <vector>

using namespace vtkOITTest;

namespace
{
using Levels = std::vector<vtkOITPartialOrder::Numbers>;

struct Case
{
  std::string Name;
  std::size_t Count;
  std::vector<std::pair<std::size_t, std::size_t>> Pairs;
  Levels Expected;
};
}

int TestPartialOrder(int, char*[])
{
  Report report;
  report.SetContext("partial order");
  for (const Case& c : std::vector<Case>{
         { "nothing", 0, {}, {} },
         { "no order", 3, {}, { { 0, 1, 2 } } },
         { "a chain", 3, { { 2, 1 }, { 1, 0 } }, { { 2 }, { 1 }, { 0 } } },
         { "a shorter way", 3, { { 0, 1 }, { 1, 2 }, { 0, 2 } }, { { 0 }, { 1 }, { 2 } } },
         { "the same pair twice", 2, { { 0, 1 }, { 0, 1 } }, { { 0 }, { 1 } } },
         { "one after two", 3, { { 0, 2 }, { 1, 2 } }, { { 0, 1 }, { 2 } } },
         { "one around another", 4, { { 0, 1 }, { 0, 2 }, { 2, 3 }, { 3, 1 } },
           { { 0 }, { 2 }, { 3 }, { 1 } } },
         { "a circle", 3, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, {} },
         { "a circle after one", 3, { { 0, 1 }, { 1, 2 }, { 2, 1 } }, {} },
       })
  {
    vtkOITPartialOrder order(c.Count);
    for (const auto& pair : c.Pairs)
    {
      order.SetBefore(pair.first, pair.second);
    }
    report.Check(order.FindLevels() == c.Expected, c.Name + ": other levels");
  }
  return report.GetExitStatus();
}
