// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Plan/vtkOITSorters.h"

#include "Private/ABuffer/vtkOITABufferEngine.h"
#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/Peeling/vtkOITDualPeelingEngine.h"
#include "Private/Volume/vtkOITVolumes.h"

#include "vtkOpenGLState.h"

#include <typeinfo>
#include <vector>

namespace
{
std::string FindMissingOf(
  const vtkOITEngine& engine, const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  const std::string missing = engine.FindMissing(*frame.Capabilities, settings);
  return missing.empty() ? engine.FindMissingIn(frame) : missing;
}

/// The application's state, for what VTK draws by itself inside of the frame's rectangle.
void BeginUnsorted(const vtkOITFrame& frame, const vtkOITSavedState& saved)
{
  saved.SetAgain();
  vtkOpenGLState* state = frame.GLState;
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.Target.Framebuffer);
  frame.Target.DrawToAllBuffers();
  const vtkOITRectangle& r = frame.Rectangle;
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(r.X, r.Y, r.Width, r.Height);
}
}

//------------------------------------------------------------------------------
vtkOITSorters::vtkOITSorters(vtkOITEngine* own)
  : Own(own)
{
}

//------------------------------------------------------------------------------
vtkOITSorters::~vtkOITSorters() = default;

//------------------------------------------------------------------------------
// nullptr where the pass's own one is of that kind.
vtkOITEngine* vtkOITSorters::Get(int which)
{
  if (which == 0)
  {
    return this->Own;
  }
  std::unique_ptr<vtkOITEngine>& engine = this->Others[which - 1];
  if (!engine)
  {
    if (which == 1)
    {
      engine = std::make_unique<vtkOITABufferEngine>();
    }
    else
    {
      engine = std::make_unique<vtkOITDualPeelingEngine>();
    }
  }
  const bool isDouble = this->Own && typeid(*this->Own) == typeid(*engine);
  return isDouble ? nullptr : engine.get();
}

//------------------------------------------------------------------------------
std::string vtkOITSorters::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings)
{
  if (this->Own)
  {
    return this->Own->FindMissing(capabilities, settings);
  }
  const std::string missing = this->Get(1)->FindMissing(capabilities, settings);
  return missing.empty() ? missing : this->Get(2)->FindMissing(capabilities, settings);
}

//------------------------------------------------------------------------------
bool vtkOITSorters::SortsLight(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  const bool isPreview = this->Own && this->Own->IsPreview();
  return !isPreview && this->HasOne(&vtkOITEngine::SortsLight, frame, settings);
}

//------------------------------------------------------------------------------
bool vtkOITSorters::HasOne(
  bool (vtkOITEngine::*ability)() const, const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  for (int which = 0; which < Count; ++which)
  {
    const vtkOITEngine* engine = this->Get(which);
    if (engine && (engine->*ability)() && FindMissingOf(*engine, frame, settings).empty())
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkOITSorters::Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
  vtkOITGeometry& geometry, vtkOITSavedState& saved, vtkOITStatistics& statistics)
{
  std::vector<vtkOITRectangle> undrawn{ frame.Rectangle };
  std::string reason; // why the best one does not draw
  bool isExpected = true;
  const bool canMix = frame.Volumes && this->HasOne(&vtkOITEngine::MixesVolumes, frame, settings);
  for (int which = 0; which < Count && !undrawn.empty(); ++which)
  {
    vtkOITEngine* engine = this->Get(which);
    if (!engine)
    {
      continue;
    }
    const bool yields = canMix && !engine->MixesVolumes() && !engine->IsPreview();
    const std::string missing =
      yields ? "a volume lies between translucent layers" : FindMissingOf(*engine, frame, settings);
    if (!missing.empty())
    {
      reason = reason.empty() ? missing : reason;
      isExpected = isExpected && engine != this->Own;
      continue;
    }
    this->ReleaseOthers(engine);
    if (engine->UsesStorage(*frame.Capabilities, settings))
    {
      saved.AddStorage();
    }
    std::vector<vtkOITRectangle> left;
    for (const vtkOITRectangle& part : undrawn)
    {
      if (const vtkOITFailure failure =
            engine->Draw(frame.Inside(part), settings, geometry, statistics))
      {
        reason = failure.GetReason();
        isExpected = false;
        const std::vector<vtkOITRectangle>& of = failure.Undrawn;
        left.insert(left.end(), of.begin(), of.end());
        left.insert(left.end(), of.empty() ? 1 : 0, part);
      }
      else if (frame.Volumes && !engine->MixesVolumes())
      {
        DrawVolumesOver(frame.Inside(part), saved, statistics);
      }
    }
    undrawn = left;
    statistics.Algorithm = engine->GetAlgorithmName(settings);
  }
  statistics.Reason = reason;
  if (!undrawn.empty())
  {
    statistics.Warning = "Translucent props are blended unsorted: " + reason;
  }
  else if (!isExpected)
  {
    statistics.Warning = "Rendered by another exact method: " + reason;
  }
  if (frame.Volumes && !canMix)
  {
    statistics.NoteWarning("A volume is drawn over the translucent props that it overlaps: shaders "
                           "cannot keep lists of fragments in this context");
  }
  for (const vtkOITRectangle& part : undrawn)
  {
    DrawUnsorted(frame.Inside(part), geometry, saved);
    if (frame.Volumes)
    {
      DrawVolumesOver(frame.Inside(part), saved, statistics);
    }
    statistics.Algorithm = "unsorted blending";
    statistics.NumberOfFragments = -1;
    statistics.MaximumDepthComplexity = -1;
    statistics.NoteError(1.0);
  }
}

//------------------------------------------------------------------------------
void vtkOITSorters::DrawUnsorted(
  const vtkOITFrame& frame, vtkOITGeometry& geometry, const vtkOITSavedState& saved)
{
  BeginUnsorted(frame, saved);
  geometry.DrawUnsorted(frame.Props);
  saved.SetNeutral();
}

//------------------------------------------------------------------------------
void vtkOITSorters::DrawVolumesOver(
  const vtkOITFrame& frame, const vtkOITSavedState& saved, vtkOITStatistics& statistics)
{
  BeginUnsorted(frame, saved);
  frame.Volumes->DrawPlainly(frame.Volumes->GetBetween());
  saved.SetNeutral();
  statistics.NoteError(1.0);
}

//------------------------------------------------------------------------------
// The limit on memory is for all together.
void vtkOITSorters::ReleaseOthers(const vtkOITEngine* used)
{
  for (int which = 0; which < Count; ++which)
  {
    vtkOITEngine* engine = which == 0 ? this->Own : this->Others[which - 1].get();
    if (engine && engine != used && engine->GetSizeInBytes() > 0)
    {
      engine->Release();
    }
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkOITSorters::GetSizeInBytes() const
{
  std::int64_t bytes = this->Own ? this->Own->GetSizeInBytes() : 0;
  for (const auto& engine : this->Others)
  {
    bytes += engine ? engine->GetSizeInBytes() : 0;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkOITSorters::Release()
{
  if (this->Own)
  {
    this->Own->Release();
  }
  for (const auto& engine : this->Others)
  {
    if (engine)
    {
      engine->Release();
    }
  }
}
