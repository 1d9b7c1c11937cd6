// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPeeler_h
#define vtkOITPeeler_h

#include "Private/Peeling/vtkOITPeelState.h"
#include "vtkType.h" // for vtkMTimeType

#include <functional>
#include <string>

class vtkProp;

/// What a peeler works with during a frame (or a band of it).
struct vtkOITPeelContext
{
  vtkOITFrame& Frame;
  vtkOITPeelState& State;
  /// In the last frame the first peel of this band had all layers.
  bool ExpectsAll;
  /// One geometry pass: the props are drawn by their mappers' shaders after WrapGather().
  std::function<void()> RenderGeometry;
};

/**
 * The part of a peeling pass that differs from method to method. vtkOITPeelingPass runs it:
 * Begin(), then Peel() until the Mask finds no pixel with fragments left, then, if it was stopped
 * before, PeelRest().
 */
class vtkOITPeeler
{
public:
  virtual ~vtkOITPeeler() = default;

  /// Peels that only prepare; they do not count for MaximumNumberOfPeels.
  virtual int GetNumberOfSetUpPeels() const { return 0; }

  /// Chooses the shaders and the memory for a frame; before everything below. `hasFloatColor`: the
  /// colours of fragments are kept as floats instead of half floats.
  virtual void Prepare(const vtkOITFrame&, bool /*hasFloatColor*/) {}

  virtual vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const = 0;
  /// Bytes per pixel beside those of the state.
  virtual int GetBytesPerPixel(const vtkOITFrame& frame) const = 0;
  virtual std::int64_t GetSizeInBytes() const = 0;

  /// Whether a prop without a fragment that passes in a peel has none for later peels.
  virtual bool CanCullProps() const { return true; }

  /// Reserves memory for the band. The state has been started.
  virtual void Begin(const vtkOITPeelContext& context) = 0;
  /// The peel of this number, from 0: geometry passes, then Resolve of the state.
  virtual void Peel(const vtkOITPeelContext& context, int number) = 0;
  /// Blends all that is left as one group, out of order: one geometry pass.
  virtual void PeelRest(const vtkOITPeelContext& context) = 0;

  /// After a peel: it has all there is, not in the state but for Composite() of the peeler, and
  /// peeling ends. May only be when the context expects it.
  virtual bool HasAll() const { return false; }
  virtual void Composite(const vtkOITPeelContext&) {}

  /// Changes a mapper's fragment shader into the Gather stage. False when it has no main().
  virtual bool WrapGather(std::string& fragmentShader) const = 0;
  /// Of a program made by WrapGather(), before each draw of a prop during RenderGeometry().
  virtual void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) = 0;
  /// When WrapGather() last changed.
  virtual vtkMTimeType GetShaderMTime() const { return 0; }

  virtual void Release() = 0;
};

#endif
