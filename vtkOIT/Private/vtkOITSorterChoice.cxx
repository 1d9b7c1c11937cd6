// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITSorterChoice.h"

#include "vtkOITFrame.h"
#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"

#include <algorithm>

namespace
{
constexpr const char* MethodNames[] = { "abuffer", "multilayer", "dual" };

// As in the documentation of the passes.
constexpr std::int64_t BytesPerFragment = 16;
constexpr std::int64_t BytesPerBandPixel = 8; // heads of lists and depth, of one band at a time
constexpr std::int64_t BytesPerPeeledPixel = 216;
constexpr int LayersPerPeel = 8;

constexpr std::int64_t DivideUp(std::int64_t value, std::int64_t by)
{
  return (value + by - 1) / by;
}
}

//------------------------------------------------------------------------------
vtkOITPass& vtkOITSorterChoice::Use(int which, std::int64_t limit, const std::string& reason)
{
  if (!this->Passes[which])
  {
    this->Passes[which].TakeReference(vtkOITPassFactory::CreatePass(MethodNames[which]));
  }
  constexpr std::int64_t smallest = 1 << 20; // that passes take
  this->Passes[which]->SetMaximumBufferSize(std::max(limit, smallest));
  this->Current = which;
  this->Reason = reason;
  return *this->Passes[which];
}

//------------------------------------------------------------------------------
bool vtkOITSorterChoice::IsPeelingCheaper(const vtkOITFrame& frame, std::int64_t limit) const
{
  const std::int64_t area = frame.Rectangle.GetArea();
  const std::int64_t bands =
    DivideUp(this->Fragments * BytesPerFragment + area * BytesPerBandPixel, limit);
  const std::int64_t peels =
    std::max<std::int64_t>(1, DivideUp(this->DepthComplexity, LayersPerPeel)) *
    DivideUp(area * BytesPerPeeledPixel, limit);
  return this->Current == MultiLayer ? 3 * peels < 4 * bands : 4 * peels < 3 * bands;
}

//------------------------------------------------------------------------------
vtkOITPass& vtkOITSorterChoice::Choose(const vtkOITFrame& frame, std::int64_t limit,
  const std::function<std::string(vtkOITPass&)>& findMissing)
{
  const int before = this->Current;
  const std::string missing =
    findMissing(this->Use(ABuffer, limit, "its fragments fit into memory"));
  this->Current = before;
  if (missing.empty() && !this->IsPeelingCheaper(frame, limit))
  {
    return this->Use(ABuffer, limit,
      this->Fragments * BytesPerFragment <= limit ? "its fragments fit into memory"
                                                  : "it needs the fewest geometry passes");
  }
  const bool canPeelLayers = findMissing(this->Use(MultiLayer, limit, missing)).empty();
  if (missing.empty())
  {
    const std::string reason = "an A-buffer would need more bands than this needs passes";
    return canPeelLayers ? this->Use(MultiLayer, limit, reason)
                         : this->Use(ABuffer, limit, "it needs the fewest geometry passes");
  }
  return canPeelLayers ? *this->Passes[MultiLayer] : this->Use(Dual, limit, missing);
}

//------------------------------------------------------------------------------
void vtkOITSorterChoice::Note(vtkOITPass& pass)
{
  this->Fragments = std::max<std::int64_t>(0, pass.GetNumberOfFragments());
  this->DepthComplexity = std::max(0, pass.GetMaximumDepthComplexity());
}

//------------------------------------------------------------------------------
void vtkOITSorterChoice::ReleaseUnused(vtkWindow* window)
{
  for (int which = 0; which < Count; ++which)
  {
    vtkOITPass* pass = this->Passes[which];
    if (pass && which != this->Current && pass->GetBufferSizeInBytes() > 0)
    {
      pass->ReleaseGraphicsResources(window);
    }
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkOITSorterChoice::GetSizeInBytes() const
{
  std::int64_t bytes = 0;
  for (const auto& pass : this->Passes)
  {
    bytes += pass ? pass->GetBufferSizeInBytes() : 0;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkOITSorterChoice::Release(vtkWindow* window)
{
  for (const auto& pass : this->Passes)
  {
    if (pass)
    {
      pass->ReleaseGraphicsResources(window);
    }
  }
  this->Fragments = 0;
  this->DepthComplexity = 0;
}
