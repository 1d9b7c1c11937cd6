// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITSorterChoice.h"

#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"

#include <algorithm>

namespace
{
constexpr const char* MethodNames[] = { "abuffer", "multilayer", "dual" };

constexpr std::int64_t BytesPerFragment = 16; // of an A-buffer
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
vtkOITPass& vtkOITSorterChoice::Choose(
  std::int64_t limit, const std::function<std::string(vtkOITPass&)>& findMissing)
{
  const bool fits = this->Fragments * BytesPerFragment <= limit;
  vtkOITPass& best = this->Use(ABuffer, limit,
    fits ? "its fragments fit into memory" : "in bands, as its fragments do not fit into memory");
  const std::string missing = findMissing(best);
  if (missing.empty())
  {
    return best;
  }
  vtkOITPass& second = this->Use(MultiLayer, limit, missing);
  return findMissing(second).empty() ? second : this->Use(Dual, limit, missing);
}

//------------------------------------------------------------------------------
void vtkOITSorterChoice::Note(vtkOITPass& pass)
{
  this->Fragments = std::max<std::int64_t>(0, pass.GetNumberOfFragments());
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
}
