// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Engine/vtkOITGather.h"

#include "Private/Engine/vtkOITGatherHook.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

#include <algorithm>

namespace
{
/// Scenes have few different shaders; one that has more wraps some again.
constexpr std::size_t MostTexts = 64;

/// Whether passes around ours are asked about the shaders of a prop, too.
bool HasOtherPasses(const vtkRenderState* state)
{
  vtkProp** first = state->GetPropArray();
  return std::any_of(first, first + state->GetPropArrayCount(),
    [](vtkProp* prop)
    {
      vtkInformation* keys = prop->GetPropertyKeys();
      return keys && keys->Length(vtkOpenGLRenderPass::RenderPasses()) > 0;
    });
}
}

vtkStandardNewMacro(vtkOITGatherHook);

//------------------------------------------------------------------------------
vtkOITGatherHook::vtkOITGatherHook()
  : Stage({})
{
}

//------------------------------------------------------------------------------
vtkOITGatherHook::~vtkOITGatherHook() = default;

//------------------------------------------------------------------------------
void vtkOITGatherHook::RenderBy(vtkRenderPass* delegate, const vtkRenderState* state)
{
  if (HasOtherPasses(state))
  {
    this->Binding = vtkOITDrawBinding::Query();
  }
  this->PreRender(state);
  delegate->Render(state);
  this->PostRender(state);
  this->Binding.reset();
}

//------------------------------------------------------------------------------
void vtkOITGatherHook::SetStage(vtkOITShaderText stage)
{
  this->Stage = std::move(stage);
  this->Wrapped.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkOITGatherHook::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const auto found = this->Wrapped.find(fragmentShader);
  if (found != this->Wrapped.end())
  {
    fragmentShader = found->second;
    return true;
  }
  const std::string before = fragmentShader;
  if (!this->Stage.Wrap(fragmentShader))
  {
    return false;
  }
  if (this->Wrapped.size() < MostTexts)
  {
    this->Wrapped.emplace(before, fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITGatherHook::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (this->Binding)
  {
    this->Binding->SetAgain();
  }
  if (this->Gather && this->Gather->Setter)
  {
    this->Gather->Setter(program, prop);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkOITGather::vtkOITGather()
  : Hook(vtkSmartPointer<vtkOITGatherHook>::New())
{
  this->Hook->Gather = this;
}

//------------------------------------------------------------------------------
// A mapper may hold the hook longer than the gather lives.
vtkOITGather::~vtkOITGather()
{
  this->Hook->Gather = nullptr;
}

//------------------------------------------------------------------------------
vtkOITGatherHook* vtkOITGather::GetHook() const
{
  return this->Hook;
}

//------------------------------------------------------------------------------
bool vtkOITGather::SetStage(vtkOITShaderText stage)
{
  if (stage == this->Hook->GetStage())
  {
    return false;
  }
  this->Hook->SetStage(std::move(stage));
  return true;
}
