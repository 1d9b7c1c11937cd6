// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Batches of props in random places: each prop is drawn once, whatever has an order is drawn in it, and
// whatever has none is sorted at once.

#include "Rig/Report.h"
#include "Scenes/Random.h"

#include "Private/Auto/vtkOITBatches.h"
#include "Private/Frame/vtkOITScreenExtents.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

using namespace vtkOITTest;

namespace
{
using Faces = vtkOITBlendSteps::Faces;
using Relation = vtkOITRelation;

struct Scene
{
  std::vector<vtkOITScreenExtent> Extents;
  std::vector<vtkOITPlacedProp> Items;
  std::vector<vtkOITPlacedProp*> Props;
};

/// Rectangles whose intervals of depth overlap now and then: planes, balls, and what is not known. In the
/// world they are all in the same place, but for balls with small ones in them.
Scene MakeScene(Random& random, int count)
{
  Scene scene;
  scene.Extents.resize(count);
  scene.Items.resize(count);
  for (int i = 0; i < count; ++i)
  {
    vtkOITScreenExtent& extent = scene.Extents[i];
    extent.IsBounded = true;
    extent.Rectangle = { random.Below(60), random.Below(60), 20 + random.Below(60), 20 };
    extent.Nearest = random.Uniform();
    extent.Farthest = extent.Nearest + 0.2 * random.Uniform() * random.Uniform();
    vtkOITPlacedProp& item = scene.Items[i];
    item.Extent = &extent;
    const int kind = random.Below(4);
    item.Shape = kind == 0 ? vtkOITMeshShape::Unknown
      : kind == 1          ? vtkOITMeshShape::ClosedConvex
                           : vtkOITMeshShape::FlatConvex;
    item.Bounds = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
    if (kind == 1 && random.Below(3) == 0)
    {
      item.Bounds = { -2.0, 2.0, -2.0, 2.0, -2.0, 2.0 };
      item.Balls.Inner = 1.9; // around all others of this depth
      item.Balls.Outer = 2.0;
    }
    else
    {
      item.Balls.Outer = 1.0;
    }
    scene.Props.push_back(&item);
  }
  return scene;
}

/// When parts are drawn. Of what is sorted, all is drawn at once.
struct Times
{
  int First = -1;
  int Last = -1;
  int Parts = 0;
  bool IsSorted = false;
};

std::map<const vtkOITPlacedProp*, Times> FindTimes(const std::vector<vtkOITPartBatch>& batches)
{
  std::map<const vtkOITPlacedProp*, Times> times;
  int now = 0;
  for (const vtkOITPartBatch& batch : batches)
  {
    for (const vtkOITParts& level : batch.Levels)
    {
      for (const vtkOITPart& part : level)
      {
        Times& of = times[part.Whole];
        of.First = of.Parts == 0 ? now : of.First;
        of.Last = now;
        ++of.Parts;
      }
      ++now;
    }
    for (const vtkOITPlacedProp* item : batch.Sorted)
    {
      times[item] = { now, now, times[item].Parts + 1, true };
    }
    ++now;
  }
  return times;
}

bool IsInOrder(const Times& first, const Times& second, Relation relation)
{
  const bool isTogether = first.IsSorted && second.IsSorted && first.First == second.First;
  switch (relation)
  {
    case Relation::FirstInFront:
      return isTogether || second.Last < first.First;
    case Relation::SecondInFront:
      return isTogether || first.Last < second.First;
    case Relation::FirstAround:
      return isTogether || (first.First < second.First && second.Last < first.Last);
    case Relation::SecondAround:
      return isTogether || (second.First < first.First && first.Last < second.Last);
    case Relation::Unknown:
      return isTogether;
    case Relation::Apart:
      return true;
  }
  return false;
}

/// Whether there are several batches.
bool CheckScene(Report& report, Random& random, int count, const std::string& name)
{
  vtkNew<vtkRenderer> renderer;
  renderer->GetActiveCamera()->ParallelProjectionOn();
  const vtkOITView view(renderer);
  const Scene scene = MakeScene(random, count);
  const std::vector<vtkOITPartBatch> batches = vtkOITFindBatches(scene.Props, view,
    [](const vtkOITPlacedProp& item) { return item.Shape == vtkOITMeshShape::Unknown; });
  std::map<const vtkOITPlacedProp*, Times> times = FindTimes(batches);
  if (batches.empty())
  {
    return false; // a circle
  }
  for (const vtkOITPlacedProp& item : scene.Items)
  {
    const Times& of = times[&item];
    report.Check(of.Parts == (item.IsClosed() && !of.IsSorted ? 2 : 1), name + ": not drawn once");
    report.Check(item.Shape != vtkOITMeshShape::Unknown || of.IsSorted, name + ": is not sorted");
    for (const vtkOITPlacedProp& other : scene.Items)
    {
      report.Check(&item == &other || IsInOrder(of, times[&other], item.Compare(other, view)),
        name + ": out of order");
    }
  }
  return batches.size() > 1;
}
}

int TestBatches(int, char*[])
{
  Report report;
  report.SetContext("batches");
  Random random(7);
  int several = 0;
  for (int i = 0; i < 400; ++i)
  {
    several += CheckScene(report, random, 2 + i % 14, "scene " + std::to_string(i)) ? 1 : 0;
  }
  report.Check(several > 100, "only " + std::to_string(several) + " scenes have several batches");
  return report.GetExitStatus();
}
