// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITPartialOrder.h"

#include <algorithm>
#include <utility>

namespace
{
struct Place
{
  std::size_t Batch = 0;
  std::size_t Level = 0; // within it
};

bool IsLater(const Place& first, const Place& second)
{
  return first.Batch != second.Batch ? first.Batch > second.Batch : first.Level > second.Level;
}
}

//------------------------------------------------------------------------------
std::vector<vtkOITPartialOrder::Numbers> vtkOITPartialOrder::FindLevels() const
{
  std::vector<Batch> batches = this->FindBatches();
  return batches.empty() ? std::vector<Numbers>() : std::move(batches.front().Levels);
}

//------------------------------------------------------------------------------
// Things are taken when all that come before them have been, so the places of those are known.
std::vector<vtkOITPartialOrder::Batch> vtkOITPartialOrder::FindBatches() const
{
  std::vector<int> left = this->CountBefore;
  std::vector<Place> places(left.size());
  Numbers taken;
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    if (left[i] == 0)
    {
      taken.push_back(i);
    }
  }
  for (std::size_t n = 0; n < taken.size(); ++n)
  {
    const std::size_t i = taken[n];
    for (const std::size_t j : this->After[i])
    {
      Place place = places[i];
      if (this->IsAtOnce[i] && !this->IsAtOnce[j])
      {
        place = { place.Batch + 1, 0 };
      }
      else if (!this->IsAtOnce[i])
      {
        ++place.Level;
      }
      places[j] = IsLater(place, places[j]) ? place : places[j];
      if (--left[j] == 0)
      {
        taken.push_back(j);
      }
    }
  }
  std::vector<Batch> batches;
  if (taken.size() < left.size())
  {
    return batches;
  }
  for (const std::size_t i : taken)
  {
    const Place& place = places[i];
    batches.resize(std::max(batches.size(), place.Batch + 1));
    Batch& batch = batches[place.Batch];
    if (this->IsAtOnce[i])
    {
      batch.AtOnce.push_back(i);
      continue;
    }
    batch.Levels.resize(std::max(batch.Levels.size(), place.Level + 1));
    batch.Levels[place.Level].push_back(i);
  }
  return batches;
}
