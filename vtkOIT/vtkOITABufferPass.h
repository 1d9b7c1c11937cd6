// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITABufferPass
 * @brief   exact transparency in one geometry pass: all fragments, sorted per pixel
 *
 * The A-buffer (Carpenter, The A-buffer, an antialiased hidden surface method, SIGGRAPH 1984) as
 * lists of fragments built on the graphics processor (Yang, Hensley, Grün and Thibieroz, Real-time
 * concurrent linked list construction on the GPU, EGSR 2010):
 *
 * 0. Solid, where it pays: props that can have fragments of opacity 1 are drawn into a copy of the
 *    depth buffer, which takes only these fragments. See SkipHiddenFragments.
 * 1. Gather: the props are drawn once, under the hardware's depth test against the opaque
 *    geometry. Each fragment takes a node of one pool, from an atomic counter or from the page of
 *    four nodes that its pixel took from it, and becomes the head of its pixel's list: by
 *    framebuffer fetch where shaders can read the framebuffer, otherwise by an atomic exchange.
 *    Nothing is drawn.
 * 2. Resolve: each tile of 16 x 16 pixels is drawn with the smallest sorting network that takes the
 *    depth complexity which the tile had in the last frame, up to 32 fragments, and up to 64 from
 *    the ninth frame on that has such tiles: that network takes seconds to compile. A pixel loads
 * its list into registers, sorts it by depth and composites it front to back, `C += T α c`, `T -= T
 * α` in float32, over what the framebuffer holds.
 * 3. The counters and the depth complexity of tiles are read back. Tiles with pixels that had more
 *    fragments than expected are drawn again for these pixels; of longer lists the nearest
 * fragments may be enough (TransmittanceThreshold, opacity 1); other long lists and coincident
 *    fragments are merge-sorted in place and composited. Lists that were drawn in order, in either
 *    direction, are not merged.
 * 4. When the pool was too small, Resolve has drawn nothing; the pool grows to the size that was
 *    counted and the frame is rendered again. Where it may not grow (MaximumBufferSize, limits of
 *    the context) the rectangle is rendered in bands that fit. The next frame starts with what was
 *    needed.
 *
 * Coincident fragments, whose float32 window depths are equal to the bit, count once each: as a
 * group they have the opacity `1 - Π(1 - α_i)` and the mean of their colours weighted by opacity.
 * The picture is the same to the last bit for every order of drawing.
 *
 * Multisampled framebuffers are resolved once a sample, from the coverage that each fragment had
 * after the depth test; one depth and colour per pixel and fragment, as in multisampling itself.
 *
 * Geometry passes: 1, when the pool was too small 2, with bands 1 each; one more where hidden
 * fragments are left out. Memory: 4 bytes per pixel, 8 where hidden fragments are left out, plus 16
 * bytes per fragment; 32 per fragment for float32 colours or multisampling. Where shaders read the
 * framebuffer, pixels take nodes by fours. Needs GL 4.3
 * with ARB_clear_texture (any GL 4.4, Mesa's llvmpipe).
 *
 * Exact: yes, unless TransmittanceThreshold is set. Colours are stored as half floats by default:
 * an error of at most 2^-11 of each colour and opacity, clamped to [0, 65504]; FLOAT keeps them as
 * they are. Limits: a prop whose mapper knows nothing of vtkOpenGLRenderPass draws nothing.
 *
 * @sa vtkOITPass
 */

#ifndef vtkOITABufferPass_h
#define vtkOITABufferPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPass.h"

#include <memory> // for the private parts

class vtkFloatArray;

class VTKOIT_EXPORT vtkOITABufferPass : public vtkOITPass
{
public:
  static vtkOITABufferPass* New();
  vtkTypeMacro(vtkOITABufferPass, vtkOITPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

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

  /// Lists of more than 32 fragments are composited up to the first behind which the transmittance
  /// is at most this. Often the nearest 24 are enough for it, and the list need not be sorted. In
  /// [0, 1], default 0: only what is behind an opacity of 1, so the result is exact. 1/512 is half
  /// a step of 8 bits. Coincident fragments make shorter lists count, too. GetErrorBound() is the
  /// largest transmittance in front of what was skipped.
  ///@{
  vtkSetClampMacro(TransmittanceThreshold, double, 0.0, 1.0);
  vtkGetMacro(TransmittanceThreshold, double);
  ///@}

  /// Whether the last frame left out hidden fragments: GetNumberOfFragments(),
  /// GetMaximumDepthComplexity() and GetFragments() are without them then.
  bool GetSkippedHiddenFragments() const;

  /// Reads back the fragments that the last frame captured, to check a picture or to analyse a
  /// scene: one tuple of 7 floats each, pixel x and y (whole numbers, from the lower left corner of
  /// the framebuffer), window depth in [0, 1], red, green, blue (not multiplied by opacity),
  /// opacity in (0, 1]. The fragments of a pixel follow each other, in no particular order. Colours
  /// are as they were stored: see FragmentPrecision. There are GetNumberOfFragments() tuples; fewer
  /// where shaders that write gl_FragDepth draw behind opaque geometry.
  ///
  /// False, with an error and an empty array, when the last frame captured nothing, was drawn in
  /// bands (MaximumBufferSize), into a multisampled framebuffer or by another method, or when its
  /// context is gone. Waits for the frame; copies 28 bytes a fragment, and as much again while it
  /// works. Not for every frame.
  bool GetFragments(vtkFloatArray* fragments);

  /// Called by mappers: the change of their shaders, and its uniforms.
  ///@{
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkOITABufferPass();
  ~vtkOITABufferPass() override;

  void RenderTranslucent(vtkOITFrame& frame) override;
  const char* GetOwnAlgorithmName() override { return "A-buffer"; }
  std::string FindMissingCapability(const vtkOITCapabilities& capabilities) override;

  bool SkipHiddenFragments = true;
  double TransmittanceThreshold = 0.0;

private:
  vtkOITABufferPass(const vtkOITABufferPass&) = delete;
  void operator=(const vtkOITABufferPass&) = delete;

  bool DrawSolidDepth(vtkOITFrame& frame);
  vtkTypeInt64 RenderBand(vtkOITFrame& frame);
  void AddStatistics(vtkTypeInt64 fragments, vtkTypeInt64 depthComplexity, double skipped);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
