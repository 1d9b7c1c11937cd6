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
#include <iterator>
#include <map>

namespace
{
/// Scenes have few different shaders; one that has more rewrites some again.
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

/// What the user of an actor replaces at the end, which VTK does after us.
std::map<vtkShader::ReplacementSpec, vtkShader::ReplacementValue> FindReplacements(vtkProp* prop)
{
  auto* property =
    prop ? vtkOpenGLShaderProperty::SafeDownCast(prop->GetShaderProperty()) : nullptr;
  auto replacements = property
    ? property->GetAllShaderReplacements()
    : std::map<vtkShader::ReplacementSpec, vtkShader::ReplacementValue>();
  for (auto it = replacements.begin(); it != replacements.end();)
  {
    it = it->first.ReplaceFirst ? replacements.erase(it) : std::next(it);
  }
  return replacements;
}

/// The same, to be compared.
std::string DescribeReplacements(vtkProp* prop)
{
  std::string text;
  for (const auto& [from, to] : FindReplacements(prop))
  {
    text += std::to_string(from.ShaderType) + from.OriginalValue + '\0' + to.Replacement +
      (to.ReplaceAll ? '\1' : '\0');
  }
  return text;
}

/// In the texts for vertices, geometry and fragments.
void ReplaceLast(std::array<std::string, 3>& texts, vtkProp* prop)
{
  for (const auto& [from, to] : FindReplacements(prop))
  {
    const vtkShader::Type type = from.ShaderType;
    const int which = type == vtkShader::Vertex ? 0 : type == vtkShader::Geometry ? 1 : 2;
    if (which < 2 || type == vtkShader::Fragment)
    {
      vtkShaderProgram::Substitute(texts[which], from.OriginalValue, to.Replacement, to.ReplaceAll);
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
    this->Known.clear(); // the version of GLSL may be another one
    this->Window = window;
  }
  this->Failure = {};
  this->NumberOfDraws = 0;
  this->Ready.clear();
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
  this->Known.clear();
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
// Many props have the same texts, and are asked for them when they change.
bool vtkOITGatherHook::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (this->Gather && this->Gather->Replacements)
  {
    this->Gather->Replacements->After(fragmentShader);
  }
  const std::string replacements = DescribeReplacements(prop);
  const auto found = std::find_if(this->Known.begin(), this->Known.end(),
    [&](const Text& text)
    {
      return text.Given[2] == fragmentShader && text.Given[1] == geometryShader &&
        text.Given[0] == vertexShader && text.Replacements == replacements;
    });
  if (found != this->Known.end() && found->Program && found->Program->GetCompiled())
  {
    geometryShader = found->Made[1];
    fragmentShader = found->Made[2];
    return true;
  }
  Text text{ { vertexShader, geometryShader, fragmentShader }, replacements, {}, nullptr };
  text.Made = text.Given;
  vtkShaderProgram* program = nullptr;
  if (!this->Make(text.Made, prop, program))
  {
    return false;
  }
  geometryShader = text.Made[1];
  fragmentShader = text.Made[2];
  if (found != this->Known.end())
  {
    this->Known.erase(found);
  }
  if (program)
  {
    text.Program = program;
    this->Known.push_front(std::move(text));
    this->Known.resize(std::min(this->Known.size(), MostTexts));
  }
  return true;
}

//------------------------------------------------------------------------------
// The texts under our stage, and the program that a mapper is going to ask the cache for with them.
// Without a program VTK draws with the one before, and some of its mappers crash. False without a main().
bool vtkOITGatherHook::Make(Texts& texts, vtkProp* prop, vtkShaderProgram*& program)
{
  ++this->NumberOfTexts;
  if (!this->Stage.Wrap(texts[2]))
  {
    return false;
  }
  if (this->Stage.ReadsPrimitives())
  {
    vtkOITHandOnPrimitives(texts[1]);
  }
  vtkOITReplaceTop(texts[2],
    [prop](std::string& top)
    {
      Texts replaced{ "", "", top };
      ReplaceLast(replaced, prop);
      top = replaced[2];
    });
  Texts last = texts;
  ReplaceLast(last, prop);
  vtkOITFailure failure = this->Window
    ? vtkOITReadyProgram(this->Window, last[0], last[1], last[2], program)
    : vtkOITFailure();
  if (failure)
  {
    this->Failure = failure;
    texts[2] = "//VTK::System::Dec\n" + Discard;
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
  if (!isDrawn || !this->Gather)
  {
    return true;
  }
  if (this->Gather->PassSetter &&
    std::find(this->Ready.begin(), this->Ready.end(), program) == this->Ready.end())
  {
    this->Gather->PassSetter(program);
    this->Ready.push_back(program);
  }
  if (this->Gather->Setter)
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
