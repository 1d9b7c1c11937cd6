// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Volume/vtkOITVolumeHook.h"

#include "Private/Engine/vtkOITPropKeys.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/GL/vtkOITProgram.h"
#include "Private/Volume/vtkOITVolumeGather.h"
#include "Private/Volume/vtkOITVolumeText.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeTexture.h"

#include <algorithm>

vtkStandardNewMacro(vtkOITVolumeHook);

namespace
{
/// Draws nothing, and compiles everywhere.
constexpr const char* Discard = "//VTK::System::Dec\nvoid main() { discard; }\n";

/// Whether a mapper draws one part of its data after the other: SetPartitions().
bool HasPartitions(vtkAbstractMapper* mapper)
{
  auto* gpuMapper = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return gpuMapper &&
    std::any_of(gpuMapper->AssembledInputs.begin(), gpuMapper->AssembledInputs.end(),
      [](const auto& input)
      {
        vtkVolumeTexture* texture = input.second.Texture;
        if (!texture)
        {
          return false;
        }
        const auto& partitions = texture->GetPartitions();
        return partitions[0] > 1 || partitions[1] > 1 || partitions[2] > 1;
      });
}
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
  if (this->IsDiscarding)
  {
    glDisable(GL_RASTERIZER_DISCARD);
    this->IsDiscarding = false;
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
    this->Failure = vtkOITFailure(
      "the shader of a volume is not VTK's, or replaces what it begins and ends with");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITVolumeHook::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  auto* window =
    this->Renderer ? vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetVTKWindow()) : nullptr;
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
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  // Known only now, when the data is loaded: SetPartitions() does not mark the mapper as modified.
  if (!this->Failure && HasPartitions(mapper))
  {
    this->Failure = vtkOITFailure("a volume is divided into partitions");
    glEnable(GL_RASTERIZER_DISCARD);
    this->IsDiscarding = true;
  }
  // What volumes behind this one have cut off the lists.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  if (!this->Failure && this->Gather && this->Gather->Setter)
  {
    this->Gather->Setter(program);
  }
  return true;
}
