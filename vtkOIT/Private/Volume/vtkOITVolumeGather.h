// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITVolumeGather_h
#define vtkOITVolumeGather_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkOITVolumeHook;
class vtkShaderProgram;

/**
 * What happens on the rays of volumes while an engine draws them between the fragments of lists: as
 * vtkOITGather for props. The stage is glsl/Volume; the engine brings what its lists are.
 */
class vtkOITVolumeGather
{
public:
  vtkOITVolumeGather();
  ~vtkOITVolumeGather();
  vtkOITVolumeGather(const vtkOITVolumeGather&) = delete;
  vtkOITVolumeGather& operator=(const vtkOITVolumeGather&) = delete;

  /// Makes the final text of a mapper's fragment shader: puts the engine's texts in the places
  /// `//VTK::OIT::Name` of the stage, and its definitions and extensions at the top.
  using Completer = std::function<std::string(const std::string& shader)>;
  void SetStage(Completer complete);

  /// Called before each draw of a volume, of its program, which is current.
  using UniformSetter = std::function<void(vtkShaderProgram* program)>;
  void SetUniforms(UniformSetter setUniforms) { this->Setter = std::move(setUniforms); }

  /// What VTK calls.
  vtkOITVolumeHook* GetHook() const;

private:
  vtkSmartPointer<vtkOITVolumeHook> Hook;
  Completer Complete;
  std::string Stage; // completed, of no mapper: tells variants apart
  UniformSetter Setter;
  friend class vtkOITVolumeHook;
};

#endif
