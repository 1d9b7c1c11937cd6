// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITGather_h
#define vtkOITGather_h

#include "Private/GL/vtkOITShaderText.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <string>
#include <utility>

class vtkOITGatherHook;
class vtkOITReplacements;
class vtkProp;
class vtkShaderProgram;

/**
 * What happens to the fragments of props while an engine draws geometry: the stage that their
 * mappers' shaders become a part of, and its uniforms, textures and state. One for each way in
 * which an engine draws props, kept from frame to frame, so that mappers keep their programs.
 */
class vtkOITGather
{
public:
  vtkOITGather();
  ~vtkOITGather();
  vtkOITGather(const vtkOITGather&) = delete;
  vtkOITGather& operator=(const vtkOITGather&) = delete;

  /// The stage from now on. True when it is another variant than before: then mappers make their
  /// programs anew, and the engine makes anew what depends on the variant.
  bool SetStage(vtkOITShaderText stage);

  /// What happens to the texts of mappers before that, or nullptr (default). To be changed together
  /// with the stage; it must outlive the gather.
  void SetReplacements(const vtkOITReplacements* replacements)
  {
    this->Replacements = replacements;
  }

  /// Called before each draw of a prop, of its program, which is current.
  using UniformSetter = std::function<void(vtkShaderProgram* program, vtkProp* prop)>;
  void SetUniforms(UniformSetter setUniforms) { this->Setter = std::move(setUniforms); }

  /// Called once in each geometry pass for each program, before its first draw: what does not depend
  /// on the prop.
  using PassUniformSetter = std::function<void(vtkShaderProgram* program)>;
  void SetPassUniforms(PassUniformSetter setUniforms) { this->PassSetter = std::move(setUniforms); }

  /// What VTK calls.
  vtkOITGatherHook* GetHook() const;

private:
  vtkSmartPointer<vtkOITGatherHook> Hook;
  const vtkOITReplacements* Replacements = nullptr;
  UniformSetter Setter;
  PassUniformSetter PassSetter;
  friend class vtkOITGatherHook;
};

#endif
