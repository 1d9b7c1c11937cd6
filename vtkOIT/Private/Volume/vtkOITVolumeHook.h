// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITVolumeHook_h
#define vtkOITVolumeHook_h

#include "Private/Frame/vtkOITFailure.h"

#include "vtkOpenGLRenderPass.h"

class vtkOITVolumeGather;

/// What VTK's volume mappers call while they draw under a gather. It draws nothing by itself.
class vtkOITVolumeHook : public vtkOpenGLRenderPass
{
public:
  static vtkOITVolumeHook* New();
  vtkTypeMacro(vtkOITVolumeHook, vtkOpenGLRenderPass);

  void Render(const vtkRenderState*) override {}

  /// Draws volumes by a delegate. Fails when the shader of one is not as VTK's, or does not compile:
  /// then nothing of it is drawn.
  vtkOITFailure RenderBy(vtkRenderPass* delegate, const vtkRenderState* state);

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->GetMTime(); }

  const vtkOITVolumeGather* Gather = nullptr; // nullptr when it is gone

protected:
  vtkOITVolumeHook() = default;
  ~vtkOITVolumeHook() override = default;

private:
  vtkOITVolumeHook(const vtkOITVolumeHook&) = delete;
  void operator=(const vtkOITVolumeHook&) = delete;

  vtkRenderer* Renderer = nullptr; // that is drawn by
  vtkOITFailure Failure;           // while drawing
  bool IsDiscarding = false;       // nothing of a volume that has failed is drawn
};

#endif
