// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPeeler_h
#define vtkOITPeeler_h

#include "Private/Engine/vtkOITGather.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Peeling/vtkOITPeelState.h"

#include <functional>
#include <string>

class vtkProp;
struct vtkOITStatistics;

/// What a peeler works with during a frame (or a band of it).
struct vtkOITPeelContext
{
  const vtkOITFrame& Frame;
  vtkOITPeelState& State;
  /// In the last frame the first peel of this band had all layers.
  bool ExpectsAll;
  /// One geometry pass: the props are drawn under the peeler's gather.
  std::function<vtkOITFailure()> RenderGeometry;
};

/**
 * The part of peeling that differs from method to method. vtkOITPeelingEngine runs it: Begin(),
 * then Peel() until the Mask finds no pixel with fragments left, then, if it was stopped before,
 * PeelRest().
 */
class vtkOITPeeler
{
public:
  virtual ~vtkOITPeeler() = default;

  /// Empty, or one line that says what the context lacks for this method.
  virtual std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings&) const
  {
    return capabilities.GetMissingForPeeling();
  }

  /// Whether it uses image units, so that they are saved.
  virtual bool UsesStorage(const vtkOITCapabilities&, const vtkOITSettings&) const { return false; }

  /// Peels that only prepare; they do not count for MaximumNumberOfPeels.
  virtual int GetNumberOfSetUpPeels() const { return 0; }

  /// Chooses the shaders and the memory for a frame; before everything below.
  virtual void Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings) = 0;

  virtual vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const = 0;
  /// Bytes per pixel beside those of the state.
  virtual int GetBytesPerPixel(const vtkOITFrame& frame) const = 0;
  virtual std::int64_t GetSizeInBytes() const = 0;

  /// Whether a prop without a fragment that passes in a peel has none for later peels.
  virtual bool CanCullProps() const { return true; }

  /// Reserves memory for the band. The state has been started.
  virtual vtkOITFailure Begin(const vtkOITPeelContext& context) = 0;
  /// The peel of this number, from 0: geometry passes, then Resolve of the state.
  virtual vtkOITFailure Peel(const vtkOITPeelContext& context, int number) = 0;
  /// Blends all that is left as one group, out of order: one geometry pass. Default: a peel for
  /// which IsRest is true.
  virtual vtkOITFailure PeelRest(const vtkOITPeelContext& context)
  {
    this->IsRest = true;
    vtkOITFailure failure = this->Peel(context, -1);
    this->IsRest = false;
    return failure;
  }

  /// After a peel: it has all there is, not in the state but for Composite() of the peeler, and
  /// peeling ends. May only be when the context expects it.
  virtual bool HasAll() const { return false; }
  virtual vtkOITFailure Composite(const vtkOITPeelContext&) { return {}; }

  /// After a peel: it was the last one, whatever the bounds of pixels say.
  virtual bool IsDone() const { return false; }

  /// The stage of the geometry pass that comes next.
  virtual vtkOITGather& GetGather() = 0;
  /// Of a program of the gather, before each draw of a prop during RenderGeometry().
  virtual void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) = 0;

  /// The frame was drawn, and this came of it. True when the next frame may need another number of
  /// peels than this one.
  virtual bool Note(const vtkOITStatistics&) { return false; }

  virtual void Release() = 0;

protected:
  /// Empty, or what the context lacks to blend coincident fragments in the order of drawing.
  static std::string FindMissingToBlend(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings)
  {
    return settings.LastOnTop && !capabilities.DrawBuffersBlend
      ? "CoincidentLayers LAST_ON_TOP: this context lacks GL_ARB_draw_buffers_blend; use a driver "
        "with OpenGL 4.0 or Mesa's llvmpipe"
      : "";
  }

  bool IsRest = false; // only during PeelRest()
};

#endif
