// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITABufferPass
 * @brief   exact transparency in one geometry pass: all fragments, sorted per pixel
 *
 * Keeps every translucent fragment of a frame in a list per pixel, sorts the lists and composites
 * them. The fastest exact method for scenes that need sorting; its memory grows with the number of
 * fragments. docs/vtkOITABufferPass.md has a picture, the stages and the limits.
 *
 * The A-buffer (Carpenter, The A-buffer, an antialiased hidden surface method, SIGGRAPH 1984) with
 * linked lists that are built on the graphics processor (Yang, Hensley, Grün and Thibieroz,
 * Real-time concurrent linked list construction on the GPU, EGSR 2010). One frame:
 *
 * 0. Solid, only where it pays: props that can have fragments of opacity 1 are drawn into a copy
 *    of the depth buffer, which takes only those fragments. See SkipHiddenFragments.
 * 1. Gather: the props are drawn once, under the hardware's depth test against the opaque
 *    geometry. Each fragment is stored in a node of a common pool and becomes the head of its
 *    pixel's list. Where shaders can read the framebuffer, a framebuffer of the pass holds the list
 *    heads, and a pixel takes nodes from the pool four at a time. Elsewhere each fragment takes one
 *    node from an atomic counter and enters the list by an atomic exchange. No colours are drawn.
 * 2. Resolve: the screen is processed in tiles of 16 x 16 pixels. A pixel loads its list into
 *    registers, sorts it by depth with a sorting network, and composites it front to back,
 *    `C += T α c`, `T -= T α` in float32, over what the framebuffer holds. The network has the size
 *    that the depth complexity of the tile in the last frame calls for: up to 32 fragments, and up
 *    to 64 from the ninth frame on that has such tiles, because that shader takes seconds to
 *    compile.
 * 3. The counters and the depth complexity of the tiles are read back. Tiles with pixels that had
 *    more fragments than expected are drawn again for these pixels. Of longer lists the nearest
 *    fragments may be enough (TransmittanceThreshold, or a fragment of opacity 1). All other long
 *    lists, and lists with coincident fragments, are merge-sorted in memory and composited; lists
 *    whose fragments were drawn front to back or back to front need no merging.
 * 4. When the pool was too small, Resolve has drawn nothing: the pool grows to the size that was
 *    counted, and the frame is rendered again. Where the pool may not grow (MaximumBufferSize,
 *    limits of the context), the screen rectangle is rendered in bands that fit. The next frame
 *    starts with what this one needed.
 *
 * Coincident fragments, whose float32 window depths are equal to the bit, form a group with the
 * opacity `1 - Π(1 - α_i)` and the mean of their colours weighted by opacity. So the picture is the
 * same to the last bit for every drawing order.
 *
 * Multisampled framebuffers are resolved once per sample, from the coverage that each fragment had
 * after the depth test. A fragment has one depth and one colour per pixel, as in multisampling
 * itself.
 *
 * Geometry passes: 1; 2 when the pool was too small; 1 per band; one more where hidden fragments
 * are left out. Memory: 4 bytes per pixel, 8 where hidden fragments are left out, and 16 bytes per
 * fragment, 32 with float32 colours or multisampling. Needs OpenGL 4.3 with ARB_clear_texture, that
 * is any OpenGL 4.4; Mesa's software renderer llvmpipe has it.
 *
 * Exact: yes, with TransmittanceThreshold 0; otherwise within GetErrorBound(). Colours are stored
 * as half floats by default: an error of at most 2^-11 of each colour and opacity, clamped to
 * [0, 65504]; FragmentPrecision FLOAT stores them as they are. Limits: a prop whose mapper does not
 * support vtkOpenGLRenderPass is not drawn.
 *
 * @sa vtkOITPass
 */

#ifndef vtkOITABufferPass_h
#define vtkOITABufferPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPass.h"

class vtkFloatArray;
class vtkOITABufferEngine;

class VTKOIT_EXPORT vtkOITABufferPass : public vtkOITPass
{
public:
  static vtkOITABufferPass* New();
  vtkTypeMacro(vtkOITABufferPass, vtkOITPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Leave out fragments behind those of opacity 1 of translucent props, as scalars and textures
  /// give them: they are invisible. Before Gather, the depth of the props that can have such
  /// fragments is drawn into a copy of the framebuffer's depth. That is one more geometry pass, so
  /// it is tried in one frame, and kept while it saves 60 % of the fragments or more. Not in
  /// multisampled framebuffers, nor where MaximumBufferSize has no room for the copy (4 bytes per
  /// pixel). Lossless, to the last bit in what blends opacities to exactly 1. Default on.
  ///@{
  vtkSetMacro(SkipHiddenFragments, bool);
  vtkGetMacro(SkipHiddenFragments, bool);
  vtkBooleanMacro(SkipHiddenFragments, bool);
  ///@}

  /// Whether the last frame left out hidden fragments: GetNumberOfFragments(),
  /// GetMaximumDepthComplexity() and GetFragments() are without them then.
  bool GetSkippedHiddenFragments() const;

  /// How often the last frame took memory for fragments by the one counter that all threads share: once
  /// for every four fragments of a pixel, or for each where shaders cannot read the framebuffer. 0 once regions
  /// of 64 x 64 pixels have memory of their own, as llvmpipe draws one by one thread: from the third frame on,
  /// or the ninth where that takes more memory, while the picture changes little. Not in bands
  /// (MaximumBufferSize).
  vtkTypeInt64 GetNumberOfSharedAllocations() const;

  /// Reads back the fragments that the last frame captured, to check a picture or to analyse a
  /// scene: one tuple of 7 floats each, pixel x and y (whole numbers, from the lower left corner of
  /// the framebuffer), window depth in [0, 1], red, green, blue (not multiplied by opacity),
  /// opacity in (0, 1]; for light (emissive Gaussians) its colour times its opacity, and 0. The fragments of a pixel follow each other, in no particular order. Colours
  /// are as they were stored: see FragmentPrecision. There are GetNumberOfFragments() tuples; fewer
  /// where shaders that write gl_FragDepth draw behind opaque geometry.
  ///
  /// False, with an error and an empty array, when the last frame captured nothing, was drawn in
  /// bands (MaximumBufferSize), into a multisampled framebuffer or by another method, or when its
  /// context is gone. Waits for the frame; copies 28 bytes a fragment, and as much again while it
  /// works. Not for every frame.
  bool GetFragments(vtkFloatArray* fragments);

protected:
  vtkOITABufferPass();
  ~vtkOITABufferPass() override;

  vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const override;

  bool SkipHiddenFragments = true;

private:
  vtkOITABufferPass(const vtkOITABufferPass&) = delete;
  void operator=(const vtkOITABufferPass&) = delete;

  vtkOITABufferEngine* Engine;
};

#endif
