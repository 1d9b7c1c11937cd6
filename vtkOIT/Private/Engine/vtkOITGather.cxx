// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Engine/vtkOITGather.h"

#include "Private/Engine/vtkOITGatherHook.h"
#include "Private/Engine/vtkOITPropKeys.h"
#include "Private/Engine/vtkOITReplacements.h"
#include "Private/GL/vtkOITProgram.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShader.h"

#include <algorithm>
#include <array>

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

/// Draws nothing, and compiles everywhere.
const std::string Discard = "void main() { discard; }\n";

bool DrawsNothing(vtkShaderProgram* program)
{
  return program->GetFragmentShader()->GetSource().find(Discard) != std::string::npos;
}

/// What the user of an actor has replaced at the end, which VTK does after us: in the texts for
/// vertices, geometry and fragments.
void ReplaceLast(std::array<std::string, 3>& texts, vtkProp* prop)
{
  auto* property =
    prop ? vtkOpenGLShaderProperty::SafeDownCast(prop->GetShaderProperty()) : nullptr;
  if (!property)
  {
    return;
  }
  for (const auto& replacement : property->GetAllShaderReplacements())
  {
    const vtkShader::Type type = replacement.first.ShaderType;
    const int which = type == vtkShader::Vertex ? 0 : type == vtkShader::Geometry ? 1 : 2;
    if (!replacement.first.ReplaceFirst && (which < 2 || type == vtkShader::Fragment))
    {
      vtkShaderProgram::Substitute(texts[which], replacement.first.OriginalValue,
        replacement.second.Replacement, replacement.second.ReplaceAll);
    }
  }
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
vtkOITFailure vtkOITGatherHook::RenderBy(
  vtkRenderPass* delegate, const vtkRenderState* state, const vtkRenderState* drawn)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetVTKWindow());
  if (window != this->Window)
  {
    this->Wrapped.clear(); // the version of GLSL may be another one
    this->Proven.clear();
    this->Window = window;
  }
  this->Failure = {};
  this->NumberOfDraws = 0;
  if (HasOtherPasses(state))
  {
    this->Binding = vtkOITDrawBinding::Query();
  }
  {
    const vtkOITPropKeys keys(state, this);
    delegate->Render(drawn);
  }
  this->Binding.reset();
  if (this->Failure)
  {
    this->Modified(); // so that mappers make their programs anew
  }
  return this->Failure;
}

//------------------------------------------------------------------------------
void vtkOITGatherHook::SetStage(vtkOITShaderText stage)
{
  this->Stage = std::move(stage);
  this->Wrapped.clear();
  this->Proven.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkOITGatherHook::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (this->Gather && this->Gather->Replacements)
  {
    this->Gather->Replacements->Before(fragmentShader, mapper, prop);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITGatherHook::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (this->Gather && this->Gather->Replacements)
  {
    this->Gather->Replacements->After(fragmentShader);
  }
  const auto found = this->Wrapped.find(fragmentShader);
  if (found != this->Wrapped.end())
  {
    fragmentShader = found->second;
  }
  else
  {
    const std::string before = fragmentShader;
    if (!this->Stage.Wrap(fragmentShader))
    {
      return false;
    }
    if (this->Wrapped.size() < MostTexts)
    {
      this->Wrapped.emplace(before, fragmentShader);
    }
  }
  if (this->Stage.ReadsPrimitives())
  {
    vtkOITHandOnPrimitives(geometryShader);
  }
  vtkOITReplaceTop(fragmentShader,
    [prop](std::string& top)
    {
      std::array<std::string, 3> texts{ "", "", top };
      ReplaceLast(texts, prop);
      top = texts[2];
    });
  if (!this->Proves(vertexShader, geometryShader, fragmentShader, prop))
  {
    fragmentShader = "//VTK::System::Dec\n" + Discard;
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the program compiles that a mapper is going to ask the cache for. Without a program VTK
// draws with the one before, and some of its mappers crash.
bool vtkOITGatherHook::Proves(const std::string& vertexShader, const std::string& geometryShader,
  const std::string& fragmentShader, vtkProp* prop)
{
  std::array<std::string, 3> texts{ vertexShader, geometryShader, fragmentShader };
  ReplaceLast(texts, prop);
  const std::string all = texts[0] + texts[1] + texts[2];
  const auto found = this->Proven.find(all);
  if (!this->Window ||
    (found != this->Proven.end() && found->second && found->second->GetCompiled()))
  {
    return true;
  }
  vtkShaderProgram* program = nullptr;
  if (vtkOITFailure failure =
        vtkOITReadyProgram(this->Window, texts[0], texts[1], texts[2], program))
  {
    this->Failure = failure;
    return false;
  }
  if (this->Proven.size() < MostTexts || found != this->Proven.end())
  {
    this->Proven[all] = program;
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
  ++this->NumberOfDraws;
  const bool isDrawn = !this->Failure || !DrawsNothing(program);
  if (isDrawn && this->Gather && this->Gather->Setter)
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
