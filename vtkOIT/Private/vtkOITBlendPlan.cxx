// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITBlendPlan.h"

#include "vtkOITBlendCost.h"
#include "vtkOITCapabilities.h"
#include "vtkOITFrame.h"
#include "vtkOITScreenRectangle.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace
{
/// Window depths nearer to each other may be equal in float32, which makes fragments coincident.
constexpr double SmallestDepthGap = 4.0 / (1 << 24);
/// The same for positions, in diagonals of the bounds.
constexpr double SmallestGap = 1e-4;

/// Pairs grow with the square of the number of props of an island.
constexpr std::size_t LargestIsland = 256;
/// Fragments of a face in pixels of its rectangle: an ellipse.
constexpr double FilledShare = 0.785;

enum class Relation
{
  Apart, // no order is needed
  FirstInFront,
  SecondInFront,
  Unknown
};

/// Where the camera is, and where it looks to.
struct View
{
  explicit View(vtkCamera* camera)
    : IsParallel(camera->GetParallelProjection() != 0)
  {
    camera->GetPosition(this->Position.data());
    camera->GetDirectionOfProjection(this->Direction.data());
  }

  /// Which side of the plane across an axis is in front: that of lower coordinates?
  bool IsLowerInFront(int axis, double plane) const
  {
    return this->IsParallel ? this->Direction[axis] >= 0.0 : this->Position[axis] <= plane;
  }

  bool IsParallel;
  std::array<double, 3> Position{};
  std::array<double, 3> Direction{};
};

/// Depths, the camera's place, and which faces of triangles are front faces are what they seem.
bool IsPlain(vtkCamera* camera)
{
  const double* shear = camera->GetViewShear();
  return camera->GetModelTransformMatrix()->IsIdentity() && !camera->GetUserTransform() &&
    !camera->GetUserViewTransform() && camera->GetUseOffAxisProjection() == 0 && shear[0] == 0.0 &&
    shear[1] == 0.0;
}

struct Item
{
  vtkProp* Prop = nullptr;
  const vtkOITScreenExtent* Extent = nullptr;
  vtkOITMeshShape Shape = vtkOITMeshShape::Unknown;
  std::array<double, 6> Bounds{};

  bool IsClosed() const
  {
    return this->Shape == vtkOITMeshShape::ClosedConvex ||
      this->Shape == vtkOITMeshShape::ClosedConvexInside;
  }
  Relation Compare(const Item& other, const View& view) const;
};
using Items = std::vector<const Item*>;

/// Items whose rectangles touch each other, directly or through others.
struct Island
{
  Items Members;
  std::vector<Items> Levels; // far to near; none when some order is not known

  bool HasClosed() const
  {
    return std::any_of(this->Members.begin(), this->Members.end(),
      [](const Item* item) { return item->IsClosed(); });
  }
};

Relation Item::Compare(const Item& other, const View& view) const
{
  if (this->Extent->Rectangle.Intersect(other.Extent->Rectangle).IsEmpty())
  {
    return Relation::Apart;
  }
  if (this->Extent->Farthest + SmallestDepthGap < other.Extent->Nearest)
  {
    return Relation::FirstInFront;
  }
  if (other.Extent->Farthest + SmallestDepthGap < this->Extent->Nearest)
  {
    return Relation::SecondInFront;
  }
  vtkBoundingBox both(this->Bounds.data());
  both.AddBounds(other.Bounds.data());
  const double gap = SmallestGap * both.GetDiagonalLength();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int low = 2 * axis;
    const int high = low + 1;
    if (this->Bounds[high] + gap < other.Bounds[low])
    {
      return view.IsLowerInFront(axis, this->Bounds[high]) ? Relation::FirstInFront
                                                           : Relation::SecondInFront;
    }
    if (other.Bounds[high] + gap < this->Bounds[low])
    {
      return view.IsLowerInFront(axis, other.Bounds[high]) ? Relation::SecondInFront
                                                           : Relation::FirstInFront;
    }
  }
  return Relation::Unknown;
}

/// About as many as the polygons of the mesh; of props whose shape is known.
std::int64_t CountTriangles(vtkProp* prop)
{
  vtkActor* actor = vtkOITFindPlainActor(prop);
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  return mesh->GetNumberOfPolys();
}

std::vector<Item> MakeItems(const vtkOITFrame& frame,
  const std::vector<vtkOITScreenExtent>& extents, vtkOITMeshShapes& shapes)
{
  // Polygon offset moves depths away from where the bounds say.
  const bool hasPlainDepth = vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_OFF &&
    IsPlain(frame.GetState()->GetRenderer()->GetActiveCamera()) && !frame.Window->GetStereoRender();
  std::vector<Item> items(extents.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    Item& item = items[i];
    item.Prop = frame.GetProps()[i];
    item.Extent = &extents[i];
    if (hasPlainDepth && extents[i].IsBounded && !extents[i].Rectangle.IsEmpty())
    {
      item.Shape = shapes.Find(item.Prop);
      std::copy_n(item.Prop->GetBounds(), 6, item.Bounds.begin());
    }
  }
  shapes.Prune();
  return items;
}

std::vector<Island> FindIslands(const std::vector<Item>& items)
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

/// Far to near: an item is on a higher level than all items behind it that share pixels with it.
/// Nothing when some order is not known, or there is none.
std::vector<Items> FindLevels(const Items& island, const View& view)
{
  const std::size_t count = island.size();
  if (count > LargestIsland ||
    std::any_of(island.begin(), island.end(),
      [](const Item* item) { return item->Shape == vtkOITMeshShape::Unknown; }))
  {
    return {};
  }
  std::vector<std::vector<std::size_t>> inFront(count); // of each
  std::vector<int> behind(count, 0);                    // how many are
  for (std::size_t a = 0; a < count; ++a)
  {
    for (std::size_t b = a + 1; b < count; ++b)
    {
      const Relation relation = island[a]->Compare(*island[b], view);
      if (relation == Relation::Unknown)
      {
        return {};
      }
      if (relation != Relation::Apart)
      {
        const bool isFirst = relation == Relation::FirstInFront;
        inFront[isFirst ? b : a].push_back(isFirst ? a : b);
        ++behind[isFirst ? a : b];
      }
    }
  }
  std::vector<Items> levels;
  std::vector<std::size_t> next;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (behind[i] == 0)
    {
      next.push_back(i);
    }
  }
  std::size_t placed = 0;
  while (!next.empty())
  {
    levels.emplace_back();
    std::vector<std::size_t> after;
    for (const std::size_t i : next)
    {
      levels.back().push_back(island[i]);
      ++placed;
      for (const std::size_t j : inFront[i])
      {
        if (--behind[j] == 0)
        {
          after.push_back(j);
        }
      }
    }
    next.swap(after);
  }
  return placed == count ? levels : std::vector<Items>(); // fewer: some are in front of each other
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

int CountLayers(const Items& island)
{
  return std::accumulate(island.begin(), island.end(), 0,
    [](int layers, const Item* item) { return layers + (item->IsClosed() ? 2 : 1); });
}

void AppendTo(std::vector<vtkOITBlendPlan::Step>& steps, const Items& items, bool areClosed,
  vtkOITBlendPlan::Faces side)
{
  vtkOITBlendPlan::Step step;
  step.Side = side;
  for (const Item* item : items)
  {
    if (item->IsClosed() == areClosed)
    {
      step.Props.push_back(item->Prop);
    }
  }
  if (step.Props.empty())
  {
    return;
  }
  if (!steps.empty() && side == vtkOITBlendPlan::Faces::All && steps.back().Side == side)
  {
    std::vector<vtkProp*>& props = steps.back().Props;
    props.insert(props.end(), step.Props.begin(), step.Props.end());
    return;
  }
  steps.push_back(std::move(step));
}
}

//------------------------------------------------------------------------------
vtkOITBlendPlan::vtkOITBlendPlan(const vtkOITFrame& frame,
  const std::vector<vtkOITScreenExtent>& extents, vtkOITMeshShapes& shapes)
{
  const std::vector<Item> items = MakeItems(frame, extents, shapes);
  for (const Item& item : items)
  {
    if (item.Shape == vtkOITMeshShape::ClosedConvexInside)
    {
      this->InsideOut.push_back(item.Prop);
    }
  }
  std::vector<Island> islands = FindIslands(items);
  const View view(frame.GetState()->GetRenderer()->GetActiveCamera());
  for (Island& island : islands)
  {
    island.Levels = FindLevels(island.Members, view);
  }
  // Peeling costs several times as much as the A-buffer that this is compared with.
  const bool blendsClosed =
    !frame.Capabilities->HasStorage() || FindCost(islands, frame.Rectangle.GetArea()).Pays();

  std::vector<Items> levels;
  for (const Island& island : islands)
  {
    const bool isBlended = !island.Levels.empty() && (blendsClosed || !island.HasClosed());
    if (isBlended)
    {
      levels.resize(std::max(levels.size(), island.Levels.size()));
      for (std::size_t level = 0; level < island.Levels.size(); ++level)
      {
        const Items& found = island.Levels[level];
        levels[level].insert(levels[level].end(), found.begin(), found.end());
      }
      this->NumberOfBlendedProps += static_cast<int>(island.Members.size());
      this->MaximumLayers = std::max(this->MaximumLayers, CountLayers(island.Members));
    }
    for (const Item* item : island.Members)
    {
      vtkOITRectangle& rectangle = isBlended ? this->BlendRectangle : this->SortedRectangle;
      rectangle = rectangle.Unite(item->Extent->Rectangle);
      if (!isBlended)
      {
        this->Sorted.push_back(item->Prop);
      }
    }
  }
  for (const Items& level : levels)
  {
    AppendTo(this->Steps, level, true, Faces::Far);
    AppendTo(this->Steps, level, true, Faces::Near);
    AppendTo(this->Steps, level, false, Faces::All);
  }
}

//------------------------------------------------------------------------------
bool vtkOITBlendPlan::IsInsideOut(vtkProp* prop) const
{
  return std::find(this->InsideOut.begin(), this->InsideOut.end(), prop) != this->InsideOut.end();
}
