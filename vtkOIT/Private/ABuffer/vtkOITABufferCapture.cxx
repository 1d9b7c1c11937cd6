// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry pass of vtkOITABufferEngine: its fragments are captured in lists, and what is
// chosen for it.
#include "Private/ABuffer/vtkOITABufferEngine.h"

#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Engine/vtkOITPropParts.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
/// What passes when there is no depth test.
constexpr int AnyDepth = 7;
}

//------------------------------------------------------------------------------
// Volumes read shaded colours, several samples would each be lit, and light has no material.
void vtkOITABufferEngine::ChooseShading(const Task& task)
{
  const vtkOITFrame& frame = task.Frame;
  using Deferral = vtkOITSettings::Deferral;
  const Deferral deferral = task.Settings.DeferShading;
  const bool canDefer = deferral != Deferral::Never && !task.Settings.FloatColor &&
    !frame.HasLight && !frame.Volumes && frame.Target.Samples == 0;
  const bool isLit =
    canDefer && !this->Lights.Update(frame) && this->Lights.GetNumberOfLights() > 0;
  this->Defers = isLit && (deferral == Deferral::Always || this->Lights.Pays(this->Defers));
  this->HasDrawn = true;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferEngine::Capture(const Task& task)
{
  vtkOITFailure failure = this->BeginBand(task);
  if (failure && this->HeadInTarget)
  {
    // The driver does not take the framebuffer of the list heads: it is not tried again.
    this->HeadInTargetWorks = false;
    this->ChooseCapture(task);
    this->ChooseShaders(task);
    this->Store.SetRegions(nullptr);
    failure = this->Store.Reserve(task.Frame.Window, *task.Frame.Capabilities, this->Band,
      this->Store.GetCapacity(), this->Shaders.GetBytesPerNode(), this->GetLargestPool(task));
    if (!failure)
    {
      failure = this->BeginBand(task);
    }
  }
  if (failure)
  {
    return failure;
  }
  this->DepthCopyFailure = {};
  this->NumberOfDraws = 0;
  failure = task.Geometry.Draw(task.Frame.Props, this->Gather);
  if (this->HasDepthCopy)
  {
    this->DepthCopy.Unbind(task.Frame.GLState, OIT_UNIT_DEPTH);
  }
  return failure ? failure : this->DepthCopyFailure;
}

//------------------------------------------------------------------------------
// Nodes that are worth asking for, so that each region has its own: not where memory is limited, nor
// where the pool would be too large for a storage block then.
std::int64_t vtkOITABufferEngine::FindNodesOfRegions(const Task& task) const
{
  const bool canGrow =
    this->HeadInTarget && task.Settings.BufferLimit == 0 && this->Band == task.Frame.Rectangle;
  const std::int64_t nodes = canGrow ? this->Regions.FindNodes(this->Band) : 0;
  const std::int64_t bytes = nodes * this->Shaders.GetBytesPerNode();
  return bytes <= task.Frame.Capabilities->MaximumStorageBlockSize ? nodes : 0;
}

//------------------------------------------------------------------------------
void vtkOITABufferEngine::ChooseRegions(const Task& task)
{
  const bool hasRegions = this->HeadInTarget && this->Band == task.Frame.Rectangle &&
    this->Regions.Plan(this->Band, this->Store.GetNodes());
  this->Store.SetRegions(hasRegions ? &this->Regions : nullptr);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferEngine::BeginBand(const Task& task)
{
  this->HasDepthCopy = false;
  this->Store.Begin(this->Band);
  vtkOpenGLState* state = task.Frame.GLState;
  task.Frame.BeginGeometry(this->Band);
  const GLboolean writesHeads = this->HeadInTarget ? GL_TRUE : GL_FALSE;
  state->vtkglColorMask(writesHeads, writesHeads, writesHeads, writesHeads);
  if (this->HasSolidDepth)
  {
    if (vtkOITFailure failure = this->SolidDepth.Bind(task.Frame))
    {
      return failure;
    }
  }
  return this->HeadInTarget ? this->Store.BindHeadFramebuffer(state) : vtkOITFailure();
}

//------------------------------------------------------------------------------
void vtkOITABufferEngine::SetUniforms(const Task& task, vtkShaderProgram* program, vtkProp* prop)
{
  // An actor may have been told to write depth; translucent ones must not.
  task.Frame.GLState->vtkglDepthMask(GL_FALSE);
  this->HasSpecular = this->HasSpecular || vtkOITDeferredText::IsReflecting(prop);
  this->HasPhysical = this->HasPhysical || vtkOITDeferredText::IsPhysical(prop);
  if (this->Shaders.HasDrawOrder())
  {
    program->SetUniformi("oitDrawNumber", this->NumberOfDraws++);
  }
  if (this->Shaders.HasLight)
  {
    program->SetUniformi("oitIsLight", vtkOITAddsLight(prop) ? 1 : 0);
  }
  if (program->IsUniformUsed("oitOpaqueDepth"))
  {
    if (!this->HasDepthCopy && !this->DepthCopyFailure)
    {
      this->DepthCopyFailure =
        this->DepthCopy.Copy(task.Frame, this->Band, this->Band, OIT_UNIT_DEPTH);
      this->HasDepthCopy = !this->DepthCopyFailure;
    }
    program->SetUniformi("oitOpaqueDepth", OIT_UNIT_DEPTH);
    program->SetUniformi("oitDepthBits", task.Frame.Target.GetFixedDepthBits());
    program->SetUniformi("oitDepthFunction",
      task.Frame.Target.TestsDepth ? task.Frame.Target.GetDepthRelations() : AnyDepth);
  }
}
