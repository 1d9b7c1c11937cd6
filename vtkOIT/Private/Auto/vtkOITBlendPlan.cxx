// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITBlendPlan.h"

#include "Private/Auto/vtkOITBlendCost.h"
#include "Private/Auto/vtkOITPartialOrder.h"
#include "Private/Auto/vtkOITPropOrder.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITScreenExtents.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace
{
/// Pairs grow with the square of the number of props of an island.
constexpr std::size_t LargestIsland = 256;
/// Fragments of a face in pixels of its rectangle: an ellipse.
constexpr double FilledShare = 0.785;

using Item = vtkOITPlacedProp;
using Relation = vtkOITRelation;
using View = vtkOITView;
using Faces = vtkOITBlendSteps::Faces;

/// What is drawn of an item in one step.
struct Part
{
  const Item* Whole = nullptr;
  Faces Side = Faces::All;
};
using Parts = std::vector<Part>;

/// Items whose rectangles touch each other, directly or through others.
struct Island
{
  std::vector<Item*> Members;
  std::vector<Parts> Levels; // far to near; none when some order is not known

  bool HasClosed() const
  {
    return std::any_of(this->Members.begin(), this->Members.end(),
      [](const Item* item) { return item->IsClosed(); });
  }
};

std::vector<Island> FindIslands(std::vector<Item>& items)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (!items[i].Extent->Rectangle.IsEmpty())
    {
      order.push_back(i);
    }
  }
  const auto getRectangle = [&items](std::size_t i) { return items[i].Extent->Rectangle; };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return getRectangle(a).X < getRectangle(b).X; });
  std::vector<std::size_t> parents(items.size());
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  const auto findRoot = [&parents](std::size_t i)
  {
    while (parents[i] != i)
    {
      i = parents[i] = parents[parents[i]];
    }
    return i;
  };
  for (auto a = order.begin(); a != order.end(); ++a)
  {
    const int right = getRectangle(*a).X + getRectangle(*a).Width;
    for (auto b = a + 1; b != order.end() && getRectangle(*b).X < right; ++b)
    {
      if (!getRectangle(*a).Intersect(getRectangle(*b)).IsEmpty())
      {
        parents[findRoot(*b)] = findRoot(*a);
      }
    }
  }
  std::vector<Island> byRoot(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (!items[i].Extent->Rectangle.IsEmpty())
    {
      byRoot[findRoot(i)].Members.push_back(&items[i]);
    }
  }
  byRoot.erase(std::remove_if(byRoot.begin(), byRoot.end(),
                 [](const Island& island) { return island.Members.empty(); }),
    byRoot.end());
  return byRoot;
}

/// False when one of the shapes is not known; then not all have been looked for.
bool FindShapes(Island& island, vtkOITMeshShapes& shapes)
{
  for (Item* item : island.Members)
  {
    item->Shape =
      item->Extent->IsBounded ? shapes.Find(item->Prop, item->Balls) : vtkOITMeshShape::Unknown;
    if (item->Shape == vtkOITMeshShape::Unknown)
    {
      return false;
    }
    std::copy_n(item->Prop->GetBounds(), 6, item->Bounds.begin());
  }
  return true;
}

/// The most that a pixel can have: one of each part.
int CountLayers(const Island& island)
{
  return std::accumulate(island.Members.begin(), island.Members.end(), 0,
    [](int layers, const Item* item) { return layers + (item->IsClosed() ? 2 : 1); });
}

/// The parts of all items, and which are behind which.
class PartOrder
{
public:
  explicit PartOrder(const Island& island)
    : Order(static_cast<std::size_t>(CountLayers(island)))
  {
    for (const Item* item : island.Members)
    {
      this->First.push_back(this->AllParts.size());
      if (item->IsClosed())
      {
        this->AllParts.push_back({ item, Faces::Far });
        this->AllParts.push_back({ item, Faces::Near });
        this->Order.SetBefore(this->First.back(), this->First.back() + 1);
      }
      else
      {
        this->AllParts.push_back({ item, Faces::All });
      }
    }
    this->First.push_back(this->AllParts.size());
  }

  void SetBehind(std::size_t back, std::size_t front)
  {
    this->Order.SetBefore(this->GetLast(back), this->First[front]);
  }
  void SetAround(std::size_t outer, std::size_t inner)
  {
    this->Order.SetBefore(this->First[outer], this->First[inner]);
    this->Order.SetBefore(this->GetLast(inner), this->GetLast(outer));
  }
  std::vector<Parts> FindLevels() const
  {
    std::vector<Parts> levels;
    for (const vtkOITPartialOrder::Numbers& numbers : this->Order.FindLevels())
    {
      levels.emplace_back();
      for (const std::size_t part : numbers)
      {
        levels.back().push_back(this->AllParts[part]);
      }
    }
    return levels;
  }

private:
  std::size_t GetLast(std::size_t item) const { return this->First[item + 1] - 1; }

  vtkOITPartialOrder Order; // of parts
  Parts AllParts;
  std::vector<std::size_t> First; // part of each item, and the end
};

/// Far to near: a part is on a higher level than all parts behind it that share pixels with it.
/// Nothing when some order is not known, or there is none.
std::vector<Parts> FindLevels(const Island& island, const View& view)
{
  const std::vector<Item*>& items = island.Members;
  PartOrder order(island);
  for (std::size_t a = 0; a < items.size(); ++a)
  {
    for (std::size_t b = a + 1; b < items.size(); ++b)
    {
      switch (items[a]->Compare(*items[b], view))
      {
        case Relation::Apart:
          break;
        case Relation::FirstInFront:
          order.SetBehind(b, a);
          break;
        case Relation::SecondInFront:
          order.SetBehind(a, b);
          break;
        case Relation::FirstAround:
          order.SetAround(a, b);
          break;
        case Relation::SecondAround:
          order.SetAround(b, a);
          break;
        case Relation::Unknown:
          return {};
      }
    }
  }
  return order.FindLevels();
}

/// About as many as the polygons of the mesh; of props whose shape is known.
std::int64_t CountTriangles(vtkProp* prop)
{
  vtkActor* actor = vtkOITFindPlainActor(prop);
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  return mesh->GetNumberOfPolys();
}

/// Of the closed items whose order is known, in a frame of `frameArea` pixels.
vtkOITBlendCost FindCost(const std::vector<Island>& islands, std::int64_t frameArea)
{
  vtkOITBlendCost cost;
  cost.FrameArea = frameArea;
  vtkOITRectangle blended;
  vtkOITRectangle left;
  for (const Island& island : islands)
  {
    for (const Item* item : island.Members)
    {
      const vtkOITRectangle& rectangle = item->Extent->Rectangle;
      if (island.Levels.empty())
      {
        left = left.Unite(rectangle);
      }
      else if (item->IsClosed())
      {
        ++cost.Props;
        cost.Triangles += CountTriangles(item->Prop);
        cost.Fragments += 2.0 * FilledShare * static_cast<double>(rectangle.GetArea());
        blended = blended.Unite(rectangle);
      }
    }
  }
  cost.BlendArea = blended.GetArea();
  cost.LeftArea = left.GetArea();
  return cost;
}

void AppendTo(std::vector<vtkOITBlendSteps::Step>& steps, const Parts& level, Faces side)
{
  vtkOITBlendSteps::Step step;
  step.Side = side;
  for (const Part& part : level)
  {
    if (part.Side == side)
    {
      step.Props.push_back(part.Whole->Prop);
    }
  }
  if (step.Props.empty())
  {
    return;
  }
  if (!steps.empty() && side == Faces::All && steps.back().Side == side)
  {
    std::vector<vtkProp*>& props = steps.back().Props;
    props.insert(props.end(), step.Props.begin(), step.Props.end());
    return;
  }
  steps.push_back(std::move(step));
}
}

//------------------------------------------------------------------------------
vtkOITBlendPlan::vtkOITBlendPlan(const vtkOITFrame& frame, vtkOITMeshShapes& shapes)
  : Sorted(frame)
{
  this->Sorted.Props.clear();
  this->Sorted.Extents.clear();
  this->Sorted.Rectangle = {};
  const View view(frame.Renderer);
  // Polygon offset moves depths away from where the bounds say.
  const bool hasPlainDepth = vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_OFF &&
    view.IsPlain && !frame.Window->GetStereoRender();
  std::vector<Item> items(frame.Props.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    items[i].Prop = frame.Props[i];
    items[i].Extent = &frame.Extents[i];
  }
  std::vector<Island> islands = FindIslands(items);
  for (Island& island : islands)
  {
    if (hasPlainDepth && island.Members.size() <= LargestIsland && FindShapes(island, shapes))
    {
      island.Levels = FindLevels(island, view);
    }
  }
  // Peeling costs several times as much as the A-buffer that this is compared with.
  const bool blendsClosed =
    !frame.Capabilities->HasStorage() || FindCost(islands, frame.Rectangle.GetArea()).Pays();
  shapes.Prune();

  std::vector<Parts> levels;
  for (const Island& island : islands)
  {
    const bool isBlended = !island.Levels.empty() && (blendsClosed || !island.HasClosed());
    if (isBlended)
    {
      levels.resize(std::max(levels.size(), island.Levels.size()));
      for (std::size_t level = 0; level < island.Levels.size(); ++level)
      {
        const Parts& found = island.Levels[level];
        levels[level].insert(levels[level].end(), found.begin(), found.end());
      }
      this->Blended.NumberOfProps += static_cast<int>(island.Members.size());
      this->Blended.MaximumLayers = std::max(this->Blended.MaximumLayers, CountLayers(island));
    }
    for (const Item* item : island.Members)
    {
      vtkOITRectangle& rectangle = isBlended ? this->Blended.Rectangle : this->Sorted.Rectangle;
      rectangle = rectangle.Unite(item->Extent->Rectangle);
      if (!isBlended)
      {
        this->Sorted.Props.push_back(item->Prop);
        this->Sorted.Extents.push_back(*item->Extent);
      }
      else if (item->Shape == vtkOITMeshShape::ClosedConvexInside)
      {
        this->Blended.InsideOut.push_back(item->Prop);
      }
    }
  }
  this->Sorted.Rectangle = this->Sorted.Rectangle.Intersect(frame.Rectangle);
  for (const Parts& level : levels)
  {
    AppendTo(this->Blended.Steps, level, Faces::Far);
    AppendTo(this->Blended.Steps, level, Faces::Near);
    AppendTo(this->Blended.Steps, level, Faces::All);
  }
}
