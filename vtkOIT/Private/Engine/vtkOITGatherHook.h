// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITGatherHook_h
#define vtkOITGatherHook_h

#include "Private/GL/vtkOITDrawBinding.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOpenGLRenderPass.h"

#include <optional>
#include <string>
#include <unordered_map>

class vtkOITGather;

/// What VTK's mappers call while props are drawn under a gather: a pass of its own for each, so that
/// mappers keep the shaders of several apart. It draws nothing by itself.
class vtkOITGatherHook : public vtkOpenGLRenderPass
{
public:
  static vtkOITGatherHook* New();
  vtkTypeMacro(vtkOITGatherHook, vtkOpenGLRenderPass);

  void Render(const vtkRenderState*) override {}

  /// Draws props by a delegate, which gets them in the state; this pass is among their
  /// vtkOpenGLRenderPass::RenderPasses() meanwhile.
  void RenderBy(vtkRenderPass* delegate, const vtkRenderState* state);

  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->GetMTime(); }

  void SetStage(vtkOITShaderText stage);
  const vtkOITShaderText& GetStage() const { return this->Stage; }

  const vtkOITGather* Gather = nullptr; // nullptr when it is gone

protected:
  vtkOITGatherHook();
  ~vtkOITGatherHook() override;

private:
  vtkOITGatherHook(const vtkOITGatherHook&) = delete;
  void operator=(const vtkOITGatherHook&) = delete;

  vtkOITShaderText Stage;
  // Other passes around ours may change where the props are drawn into, before each draw.
  std::optional<vtkOITDrawBinding> Binding;
  std::unordered_map<std::string, std::string> Wrapped; // texts of mappers, and what became of them
};

#endif
