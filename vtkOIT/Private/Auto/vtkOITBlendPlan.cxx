// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITBlendPlan.h"

#include "Private/Auto/vtkOITBatches.h"
#include "Private/Auto/vtkOITBlendCost.h"
#include "Private/Auto/vtkOITDisjointSets.h"
#include "Private/Auto/vtkOITPropOrder.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITPropInput.h"
#include "Private/Frame/vtkOITScreenExtents.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <functional>

namespace
{
/// Pairs grow with the square of the number of props of an island.
constexpr std::size_t LargestIsland = 256;
/// Of smaller islands with an order that is not known, nothing is blended.
constexpr std::size_t SmallestPartial = 4;
/// Fragments of a face in pixels of its rectangle: an ellipse.
constexpr double FilledShare = 0.785;

using Item = vtkOITPlacedProp;
using Part = vtkOITPart;
using Parts = vtkOITParts;
using View = vtkOITView;
using Faces = vtkOITBlendSteps::Faces;

/// Items whose rectangles touch each other, directly or through others.
struct Island
{
  std::vector<Item*> Members;
  std::vector<vtkOITPartBatch> Batches; // none when it is sorted as a whole
  bool IsKnown = false;                 // the order of all members

  void FindOrder(const View& view, const std::function<bool(const Item&)>& needsSorting)
  {
    this->Batches = vtkOITFindBatches(this->Members, view, needsSorting);
    this->IsKnown = this->Batches.size() == 1 && this->Batches.front().Sorted.empty();
  }

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
  vtkOITDisjointSets sets(items.size());
  for (auto a = order.begin(); a != order.end(); ++a)
  {
    const int right = getRectangle(*a).X + getRectangle(*a).Width;
    for (auto b = a + 1; b != order.end() && getRectangle(*b).X < right; ++b)
    {
      if (!getRectangle(*a).Intersect(getRectangle(*b)).IsEmpty())
      {
        sets.Unite(*a, *b);
      }
    }
  }
  std::vector<Island> byRoot(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (!items[i].Extent->Rectangle.IsEmpty())
    {
      byRoot[sets.Find(i)].Members.push_back(&items[i]);
    }
  }
  byRoot.erase(std::remove_if(byRoot.begin(), byRoot.end(),
                 [](const Island& island) { return island.Members.empty(); }),
    byRoot.end());
  return byRoot;
}

/// False when the depths of one are not within its bounds; then not all have been looked for.
bool FindShapes(Island& island, vtkOITMeshShapes& shapes)
{
  for (Item* item : island.Members)
  {
    item->Shape =
      item->Extent->IsBounded ? shapes.Find(item->Prop, item->Balls) : vtkOITMeshShape::Unknown;
    if (item->Shape == vtkOITMeshShape::Unknown &&
      (!item->Extent->IsBounded || island.Members.size() < SmallestPartial ||
        !vtkOITMeshShapes::IsSurface(item->Prop)))
    {
      return false;
    }
    vtkOITGetBounds(item->Prop, item->Bounds.data());
  }
  return true;
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
      if (!island.IsKnown)
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

/// Batches of the same number of all islands, which share no pixels, are drawn together.
class OrderMaker
{
public:
  explicit OrderMaker(const vtkOITFrame& frame)
    : Frame(frame)
  {
  }

  void Add(const Island& island)
  {
    if (island.Batches.empty())
    {
      for (const Item* item : island.Members)
      {
        AddTo(this->GetBatch(0).Sort, *item);
      }
    }
    for (std::size_t b = 0; b < island.Batches.size(); ++b)
    {
      vtkOITBatch& batch = this->GetBatch(b);
      this->AddLevels(b, island.Batches[b].Levels);
      for (const Item* item : island.Batches[b].Sorted)
      {
        AddTo(batch.Sort, *item);
      }
    }
  }

  vtkOITOrder Finish()
  {
    for (std::size_t b = 0; b < this->Levels.size(); ++b)
    {
      vtkOITBatch& batch = this->Order.Batches[b];
      batch.Sort.Rectangle = batch.Sort.Rectangle.Intersect(this->Frame.Rectangle);
      for (const Parts& level : this->Levels[b])
      {
        for (const Faces side : { Faces::Far, Faces::Near, Faces::All })
        {
          AppendTo(batch.Blend.Steps, level, side);
        }
      }
    }
    return std::move(this->Order);
  }

private:
  vtkOITBatch& GetBatch(std::size_t b)
  {
    while (this->Levels.size() <= b)
    {
      vtkOITBatch batch;
      batch.Sort = this->Frame;
      batch.Sort.Props.clear();
      batch.Sort.Extents.clear();
      batch.Sort.Rectangle = {};
      this->Order.Batches.push_back(std::move(batch));
      this->Levels.emplace_back();
    }
    return this->Order.Batches[b];
  }

  static void AddTo(vtkOITFrame& sort, const Item& item)
  {
    sort.Props.push_back(item.Prop);
    sort.Extents.push_back(*item.Extent);
    sort.Rectangle = sort.Rectangle.Unite(item.Extent->Rectangle);
  }

  /// Of an island, which can have all of its parts at a pixel.
  void AddLevels(std::size_t b, const std::vector<Parts>& levels)
  {
    vtkOITBlendSteps& blend = this->Order.Batches[b].Blend;
    int layers = 0;
    this->Levels[b].resize(std::max(this->Levels[b].size(), levels.size()));
    for (std::size_t l = 0; l < levels.size(); ++l)
    {
      Parts& all = this->Levels[b][l];
      all.insert(all.end(), levels[l].begin(), levels[l].end());
      layers += static_cast<int>(levels[l].size());
      for (const Part& part : levels[l])
      {
        blend.NumberOfProps += part.Side == Faces::Near ? 0 : 1;
        blend.Rectangle = blend.Rectangle.Unite(part.Whole->Extent->Rectangle);
        if (part.Whole->Shape == vtkOITMeshShape::ClosedConvexInside)
        {
          blend.InsideOut.push_back(part.Whole->Prop);
        }
      }
    }
    blend.MaximumLayers = std::max(blend.MaximumLayers, layers);
  }

  const vtkOITFrame& Frame;
  vtkOITOrder Order;
  std::vector<std::vector<Parts>> Levels; // of each batch
};
}

//------------------------------------------------------------------------------
vtkOITBlendPlan::vtkOITBlendPlan(const vtkOITFrame& frame, vtkOITMeshShapes& shapes)
{
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
  const auto isUnknown = [](const Item& item) { return item.Shape == vtkOITMeshShape::Unknown; };
  std::vector<Island*> placed; // their shapes are known, and where they are
  for (Island& island : islands)
  {
    if (hasPlainDepth && island.Members.size() <= LargestIsland && FindShapes(island, shapes))
    {
      placed.push_back(&island);
      island.FindOrder(view, isUnknown);
    }
  }
  // Peeling costs several times as much as the A-buffer that this is compared with.
  const double frameArea = static_cast<double>(frame.Rectangle.GetArea());
  const bool blendsClosed =
    !frame.Capabilities->HasStorage() || FindCost(islands, frame.Rectangle.GetArea()).Pays();
  shapes.Prune();
  for (Island* island : placed)
  {
    if (!blendsClosed && island->HasClosed())
    {
      island->FindOrder(view, [&](const Item& item) { return isUnknown(item) || item.IsClosed(); });
    }
    if (!island->IsKnown &&
      (island->Members.size() < SmallestPartial || !vtkOITBatchesPay(island->Batches, frameArea)))
    {
      island->Batches.clear();
    }
  }
  OrderMaker maker(frame);
  std::for_each(
    islands.begin(), islands.end(), [&maker](const Island& island) { maker.Add(island); });
  this->Order = maker.Finish();
}
