// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Plan/vtkOITHookTrial.h"

#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Engine/vtkOITPropParts.h"
#include "Private/Frame/vtkOITFrame.h"

#include "vtkOITHookTrialFS.h"

#include "vtkOpenGLState.h"
#include "vtkProp.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
constexpr int Side = 128; // pixels of the picture: lines and small parts are drawn into it, too
}

//------------------------------------------------------------------------------
vtkOITHookTrial::vtkOITHookTrial()
{
  this->Gather.SetStage(vtkOITShaderText({ vtkOITHookTrialFS }));
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITHookTrial::TakeUnsorted(vtkOITFrame& frame, vtkOITGeometry& geometry,
  const std::vector<vtkProp*>& denying, const std::function<bool()>& sortsLight)
{
  std::vector<vtkProp*> unhooked = FindDrawn(frame, geometry, denying);
  std::vector<vtkProp*> hooked;
  for (vtkProp* prop : frame.Props)
  {
    if (vtkOITIsSimpleActor(prop))
    {
      const bool addsLight = vtkOITAddsLight(prop);
      frame.HasLight = frame.HasLight || (addsLight && sortsLight());
      (addsLight && !frame.HasLight ? unhooked : hooked).push_back(prop);
      continue;
    }
    Entry& entry = this->Entries[prop];
    const vtkMTimeType time = prop->GetRedrawMTime();
    if (entry.Prop != prop)
    {
      entry = { prop, Found::Nothing, 0 };
    }
    if (entry.Result == Found::Nothing || entry.Result == Found::Unknown ||
      (entry.Result == Found::Hooked && entry.Time != time))
    {
      entry.Result = this->Try(frame, geometry, prop);
      entry.Time = time;
    }
    const bool asks = entry.Result == Found::Nothing || entry.Result == Found::Hooked;
    (asks ? hooked : unhooked).push_back(prop);
  }
  frame.Props = std::move(hooked);
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it = it->second.Prop ? std::next(it) : this->Entries.erase(it);
  }
  return unhooked;
}

//------------------------------------------------------------------------------
// They draw into no pixel.
std::vector<vtkProp*> vtkOITHookTrial::FindDrawn(
  const vtkOITFrame& frame, vtkOITGeometry& geometry, const std::vector<vtkProp*>& props)
{
  std::vector<vtkProp*> drawn;
  if (!props.empty())
  {
    frame.BeginGeometry({ 0, 0, 0, 0 });
    std::copy_if(props.begin(), props.end(), std::back_inserter(drawn),
      [&geometry](vtkProp* prop) { return geometry.TryUnsorted(prop); });
  }
  return drawn;
}

//------------------------------------------------------------------------------
vtkOITHookTrial::Found vtkOITHookTrial::Try(
  const vtkOITFrame& frame, vtkOITGeometry& geometry, vtkProp* prop)
{
  vtkOpenGLState* state = frame.GLState;
  if (this->Picture.Reserve(frame.Window, Side, Side, 1, GL_RGBA16F) ||
    this->Framebuffer.Bind(frame.Window, { this->Picture.GetLayer(0) }))
  {
    return Found::Unknown;
  }
  frame.BeginStorage({ 0, 0, Side, Side }, { 0, 0, 0, 0 });
  state->vtkglViewport(0, 0, Side, Side);
  state->vtkglDisable(GL_DEPTH_TEST);
  this->Query.StartRow(frame.Window);
  this->Query.Begin(0);
  const int draws = geometry.Try(prop, this->Gather);
  this->Query.End();
  const std::int64_t samples = this->Query.GetResult(0);
  return samples < 0 ? Found::Unknown
    : samples > 0    ? Found::Unhooked
    : draws > 0      ? Found::Hooked
                     : Found::Nothing;
}

//------------------------------------------------------------------------------
void vtkOITHookTrial::Release()
{
  this->Entries.clear();
  this->Picture.Release();
  this->Framebuffer.Release();
  this->Query.Release();
}
