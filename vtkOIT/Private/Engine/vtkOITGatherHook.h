// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITGatherHook_h
#define vtkOITGatherHook_h

#include "Private/Frame/vtkOITFailure.h"
#include "Private/GL/vtkOITDrawBinding.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <array>
#include <deque>
#include <optional>
#include <string>
#include <vector>

class vtkOITGather;

/// What VTK's mappers call while props are drawn under a gather: a pass of its own for each, so that
/// mappers keep the shaders of several apart. It draws nothing by itself.
class vtkOITGatherHook : public vtkOpenGLRenderPass
{
public:
  static vtkOITGatherHook* New();
  vtkTypeMacro(vtkOITGatherHook, vtkOpenGLRenderPass);

  void Render(const vtkRenderState*) override {}

  /// Draws props by a delegate, which gets them in the state `drawn`; this pass is among the
  /// vtkOpenGLRenderPass::RenderPasses() of those of `state` meanwhile. Fails when a program of
  /// theirs does not compile: then their fragments are discarded, as VTK cannot do without a
  /// program, and the next call tries again.
  vtkOITFailure RenderBy(
    vtkRenderPass* delegate, const vtkRenderState* state, const vtkRenderState* drawn);

  /// Draws in the last RenderBy(): a mapper calls SetShaderParameters() before each.
  int GetNumberOfDraws() const { return this->NumberOfDraws; }
  /// Texts that were rewritten so far, which takes long: once for all props with the same.
  int GetNumberOfTexts() const { return this->NumberOfTexts; }

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
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

  /// The texts of a mapper for vertices, geometry and fragments.
  using Texts = std::array<std::string, 3>;
  /// What became of texts, of a prop with such replacements of its user's, and the program of that.
  struct Text
  {
    Texts Given;
    std::string Replacements;
    Texts Made;
    vtkWeakPointer<vtkShaderProgram> Program;
  };
  bool Make(Texts& texts, vtkProp* prop, vtkShaderProgram*& program);

  vtkOITShaderText Stage;
  // Other passes around ours may change where the props are drawn into, before each draw.
  std::optional<vtkOITDrawBinding> Binding;
  std::deque<Text> Known;                       // the last one first
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of Known, and that is drawn into
  std::vector<vtkShaderProgram*> Ready;         // of those that have their uniforms in this pass
  vtkOITFailure Failure;                        // while drawing
  int NumberOfDraws = 0;
  int NumberOfTexts = 0;
};

#endif
