// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Volume/vtkOITVolumeHook.h"

#include "Private/Engine/vtkOITPropKeys.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/GL/vtkOITProgram.h"
#include "Private/Volume/vtkOITVolumeGather.h"
#include "Private/Volume/vtkOITVolumeText.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeMapper.h"

vtkStandardNewMacro(vtkOITVolumeHook);

namespace
{
/// Draws nothing, and compiles everywhere.
constexpr const char* Discard = "//VTK::System::Dec\nvoid main() { discard; }\n";
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITVolumeHook::RenderBy(vtkRenderPass* delegate, const vtkRenderState* state)
{
  this->Failure = {};
  this->Renderer = state->GetRenderer();
  {
    const vtkOITPropKeys keys(state, this);
    delegate->Render(state);
  }
  this->Renderer = nullptr;
  if (this->Failure)
  {
    this->Modified(); // so that mappers make their programs anew
  }
  return this->Failure;
}

//------------------------------------------------------------------------------
bool vtkOITVolumeHook::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  auto* volumeMapper = vtkVolumeMapper::SafeDownCast(mapper);
  if (!volumeMapper || !vtkOITAddMarch(fragmentShader, volumeMapper->GetBlendMode()))
  {
    this->Failure =
      vtkOITFailure("the shader of a volume is not VTK's, or replaces what it begins and ends with");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITVolumeHook::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  auto* window = this->Renderer
    ? vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetVTKWindow())
    : nullptr;
  if (!this->Failure && this->Gather && window)
  {
    fragmentShader = this->Gather->Complete(fragmentShader);
    vtkShaderProgram* program = nullptr;
    this->Failure =
      vtkOITReadyProgram(window, vertexShader, geometryShader, fragmentShader, program);
  }
  if (this->Failure || !this->Gather)
  {
    fragmentShader = Discard;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITVolumeHook::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  // What volumes behind this one have cut off the lists.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  if (!this->Failure && this->Gather && this->Gather->Setter)
  {
    this->Gather->Setter(program);
  }
  return true;
}
