// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITHookTrial_h
#define vtkOITHookTrial_h

#include "Private/Engine/vtkOITGather.h"
#include "Private/GL/vtkOITFramebuffer.h"
#include "Private/GL/vtkOITOcclusionQueries.h"
#include "Private/GL/vtkOITTextureArray.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <map>
#include <vector>

class vtkOITGeometry;
class vtkProp;
struct vtkOITFrame;

/**
 * Finds props that draw without asking our hooks, which would draw over what engines gather:
 * representations of widgets and other props made of parts that do not hand on their property keys,
 * mappers that know nothing of vtkOpenGLRenderPass.
 *
 * How a prop is drawn is found by a trial, not from a list of names: it is drawn once into a small
 * picture under a gather that leaves out all fragments; what an occlusion query still counts did not
 * go through the hook. Plain actors with VTK's own mappers are not tried. A trial is kept until the
 * prop changes; a prop that was found stays one. Props that add light are taken with them where no
 * engine sorts these.
 */
class vtkOITHookTrial
{
public:
  vtkOITHookTrial();

  /// Takes such props out of the frame and returns them, with those of `denying` that draw something
  /// although they say that they have nothing translucent, and those that add light unless
  /// `sortsLight`: then the frame knows that it has some. Changes framebuffer, viewport, scissor,
  /// masks and tests.
  std::vector<vtkProp*> TakeUnsorted(vtkOITFrame& frame, vtkOITGeometry& geometry,
    const std::vector<vtkProp*>& denying, const std::function<bool()>& sortsLight);

  void Release();

private:
  enum class Found
  {
    Nothing, // it is drawn nowhere in this view
    Hooked,
    Unhooked,
    Unknown // no trial was possible; taken for unhooked, and tried again
  };
  struct Entry
  {
    vtkWeakPointer<vtkProp> Prop; // nullptr when another one may have its address
    Found Result = Found::Nothing;
    vtkMTimeType Time = 0;
  };
  static std::vector<vtkProp*> FindDrawn(
    const vtkOITFrame& frame, vtkOITGeometry& geometry, const std::vector<vtkProp*>& props);
  Found Try(const vtkOITFrame& frame, vtkOITGeometry& geometry, vtkProp* prop);

  std::map<vtkProp*, Entry> Entries;
  vtkOITGather Gather;
  vtkOITTextureArray Picture;
  vtkOITFramebuffer Framebuffer;
  vtkOITOcclusionQueries Query;
};

#endif
