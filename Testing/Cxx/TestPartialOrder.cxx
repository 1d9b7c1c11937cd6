// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Levels of things of which some come before others: each on the lowest that can be. Batches where
// some are done at once: each in the first that can be.

#include "Rig/Report.h"

#include "Private/Auto/vtkOITPartialOrder.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace vtkOITTest;

namespace
{
using Numbers = vtkOITPartialOrder::Numbers;
using Levels = std::vector<Numbers>;
using Batch = vtkOITPartialOrder::Batch;

struct Case
{
  std::string Name;
  std::size_t Count;
  std::vector<std::pair<std::size_t, std::size_t>> Pairs;
  Levels Expected;
};

struct BatchCase
{
  std::string Name;
  std::size_t Count;
  Numbers AtOnce;
  std::vector<std::pair<std::size_t, std::size_t>> Pairs;
  std::vector<Batch> Expected;
};

bool IsSame(const std::vector<Batch>& first, const std::vector<Batch>& second)
{
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
    [](const Batch& a, const Batch& b) { return a.Levels == b.Levels && a.AtOnce == b.AtOnce; });
}

void CheckBatches(Report& report)
{
  for (const BatchCase& c : std::vector<BatchCase>{
         { "all at once", 2, { 0, 1 }, { { 0, 1 } }, { { {}, { 0, 1 } } } },
         { "one before", 2, { 1 }, { { 0, 1 } }, { { { { 0 } }, { 1 } } } },
         { "one after", 2, { 0 }, { { 0, 1 } }, { { {}, { 0 } }, { { { 1 } }, {} } } },
         { "one between", 3, { 0, 2 }, { { 0, 1 }, { 1, 2 } },
           { { {}, { 0 } }, { { { 1 } }, { 2 } } } },
         { "one beside", 3, { 0 }, { { 0, 1 } }, { { { { 2 } }, { 0 } }, { { { 1 } }, {} } } },
         { "levels begin anew", 4, { 1 }, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 0, 3 } },
           { { { { 0 } }, { 1 } }, { { { 2 }, { 3 } }, {} } } },
         { "a later batch wins over a higher level", 5, { 3 },
           { { 0, 1 }, { 1, 2 }, { 2, 4 }, { 3, 4 } },
           { { { { 0 }, { 1 }, { 2 } }, { 3 } }, { { { 4 } }, {} } } },
         { "a circle", 2, { 0 }, { { 0, 1 }, { 1, 0 } }, {} },
       })
  {
    vtkOITPartialOrder order(c.Count);
    for (const std::size_t i : c.AtOnce)
    {
      order.SetAtOnce(i);
    }
    for (const auto& pair : c.Pairs)
    {
      order.SetBefore(pair.first, pair.second);
    }
    report.Check(IsSame(order.FindBatches(), c.Expected), c.Name + ": other batches");
  }
}
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
  CheckBatches(report);
  return report.GetExitStatus();
}
