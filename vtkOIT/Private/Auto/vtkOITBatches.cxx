// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITBatches.h"

#include "Private/Auto/vtkOITBlendCost.h"
#include "Private/Auto/vtkOITDisjointSets.h"
#include "Private/Auto/vtkOITPartialOrder.h"
#include "Private/Frame/vtkOITScreenExtents.h"

#include <algorithm>
#include <iterator>

namespace
{
using Faces = vtkOITBlendSteps::Faces;
using Item = vtkOITPlacedProp;
using Relation = vtkOITRelation;

/// Which items are sorted together: sets that are united.
class Clusters
{
public:
  explicit Clusters(std::size_t count)
    : Sets(count)
    , AreSorted(count, false)
  {
  }
  std::size_t Find(std::size_t i) { return this->Sets.Find(i); }
  void SetSorted(std::size_t i) { this->AreSorted[this->Find(i)] = true; }
  bool IsSorted(std::size_t i) { return this->AreSorted[this->Find(i)]; }
  void SortTogether(std::size_t a, std::size_t b)
  {
    this->Sets.Unite(a, b);
    this->SetSorted(a);
  }
  /// Then no order matters.
  bool AreOne() const { return this->Sets.GetNumberOfSets() == 1; }

private:
  vtkOITDisjointSets Sets;
  std::vector<bool> AreSorted; // of the first of each set
};

/// The things of a partial order: parts of items that are blended, and clusters.
class Things
{
public:
  Things(const std::vector<Item*>& items, Clusters& clusters)
    : First(items.size())
    , Last(items.size())
  {
    std::vector<std::size_t> ofCluster(items.size(), None);
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      std::size_t* thing = clusters.IsSorted(i) ? &ofCluster[clusters.Find(i)] : nullptr;
      if (thing && *thing != None)
      {
        this->First[i] = this->Last[i] = *thing;
        this->Members[*thing].push_back(items[i]);
        continue;
      }
      this->First[i] = this->Last[i] = this->Parts.size();
      if (thing)
      {
        *thing = this->Parts.size();
        this->Add({}, { items[i] });
      }
      else if (items[i]->IsClosed())
      {
        this->Add({ items[i], Faces::Far }, {});
        this->Add({ items[i], Faces::Near }, {});
        this->Last[i] = this->First[i] + 1;
      }
      else
      {
        this->Add({ items[i], Faces::All }, {});
      }
    }
  }

  vtkOITPartialOrder MakeOrder() const
  {
    vtkOITPartialOrder order(this->Parts.size());
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      if (!this->Members[i].empty())
      {
        order.SetAtOnce(i);
      }
    }
    for (std::size_t item = 0; item < this->First.size(); ++item)
    {
      if (this->First[item] != this->Last[item])
      {
        order.SetBefore(this->First[item], this->Last[item]);
      }
    }
    return order;
  }

  std::vector<vtkOITPart> Parts;                 // of each thing; none of a cluster
  std::vector<std::vector<const Item*>> Members; // of a cluster
  std::vector<std::size_t> First;                // thing of each item
  std::vector<std::size_t> Last;

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  void Add(const vtkOITPart& part, const std::vector<const Item*>& members)
  {
    this->Parts.push_back(part);
    this->Members.push_back(members);
  }
};

struct Pair
{
  std::size_t First;
  std::size_t Second;
  Relation How;
};

/// Pairs of one cluster are sorted anyway.
void AddTo(vtkOITPartialOrder& order, const Pair& pair, const Things& things)
{
  const std::size_t a = pair.First;
  const std::size_t b = pair.Second;
  if (things.First[a] == things.First[b])
  {
    return;
  }
  const auto setBehind = [&](std::size_t back, std::size_t front)
  { order.SetBefore(things.Last[back], things.First[front]); };
  const auto setAround = [&](std::size_t outer, std::size_t inner)
  {
    order.SetBefore(things.First[outer], things.First[inner]);
    order.SetBefore(things.Last[inner], things.Last[outer]);
  };
  switch (pair.How)
  {
    case Relation::FirstInFront:
      setBehind(b, a);
      break;
    case Relation::SecondInFront:
      setBehind(a, b);
      break;
    case Relation::FirstAround:
      setAround(a, b);
      break;
    case Relation::SecondAround:
      setAround(b, a);
      break;
    case Relation::Apart:
    case Relation::Unknown:
      break;
  }
}

double GetArea(const Item& item)
{
  return static_cast<double>(item.Extent->Rectangle.GetArea());
}

/// What sorting fragments costs on an area, in fragments that are blended.
double FindSortingCost(double fragments, double area)
{
  const bool isDeep = fragments > vtkOITBlendCost::DeepLayers * area;
  return fragments * (1.0 + (isDeep ? vtkOITBlendCost::SortedDeep : vtkOITBlendCost::Sorted)) +
    vtkOITBlendCost::SortedBatchPixel * area;
}
}

//------------------------------------------------------------------------------
std::vector<vtkOITPartBatch> vtkOITFindBatches(const std::vector<Item*>& props,
  const vtkOITView& view, const std::function<bool(const Item&)>& needsSorting)
{
  Clusters clusters(props.size());
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < props.size() && !(a > 0 && clusters.AreOne()); ++a)
  {
    if (needsSorting(*props[a]))
    {
      clusters.SetSorted(a);
    }
    for (std::size_t b = a + 1; b < props.size() && !clusters.AreOne(); ++b)
    {
      const Relation relation = props[a]->Compare(*props[b], view);
      if (relation == Relation::Unknown)
      {
        clusters.SortTogether(a, b);
      }
      else if (relation != Relation::Apart)
      {
        pairs.push_back({ a, b, relation });
      }
    }
  }
  const Things things(props, clusters);
  vtkOITPartialOrder order = things.MakeOrder();
  for (const Pair& pair : pairs)
  {
    AddTo(order, pair, things);
  }
  std::vector<vtkOITPartBatch> batches;
  for (const vtkOITPartialOrder::Batch& found : order.FindBatches())
  {
    vtkOITPartBatch batch;
    for (const vtkOITPartialOrder::Numbers& level : found.Levels)
    {
      vtkOITParts parts;
      std::transform(level.begin(), level.end(), std::back_inserter(parts),
        [&things](std::size_t i) { return things.Parts[i]; });
      batch.Levels.push_back(std::move(parts));
    }
    for (const std::size_t cluster : found.AtOnce)
    {
      const std::vector<const Item*>& members = things.Members[cluster];
      batch.Sorted.insert(batch.Sorted.end(), members.begin(), members.end());
    }
    batches.push_back(std::move(batch));
  }
  return batches;
}

//------------------------------------------------------------------------------
bool vtkOITBatchesPay(const std::vector<vtkOITPartBatch>& batches, double frameArea)
{
  double blended = 0.0;
  double sorted = 0.0;
  double spent = vtkOITBlendCost::LayerPixel * frameArea;
  vtkOITRectangle all;
  for (const vtkOITPartBatch& batch : batches)
  {
    for (const vtkOITParts& level : batch.Levels)
    {
      for (const vtkOITPart& part : level)
      {
        blended += GetArea(*part.Whole);
        all = all.Unite(part.Whole->Extent->Rectangle);
      }
    }
    double ofBatch = 0.0;
    vtkOITRectangle rectangle;
    for (const Item* item : batch.Sorted)
    {
      ofBatch += GetArea(*item);
      rectangle = rectangle.Unite(item->Extent->Rectangle);
    }
    if (!batch.Sorted.empty())
    {
      spent += FindSortingCost(ofBatch, static_cast<double>(rectangle.GetArea())) +
        vtkOITBlendCost::SortedBatch;
      sorted += ofBatch;
      all = all.Unite(rectangle);
    }
  }
  const double whole = FindSortingCost(blended + sorted, static_cast<double>(all.GetArea()));
  return spent + vtkOITBlendCost::BlendedIntoLayer * blended < whole;
}
