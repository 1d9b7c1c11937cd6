// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPeelState_h
#define vtkOITPeelState_h

#include "Private/GL/vtkOITDepthCopy.h"
#include "Private/GL/vtkOITFramebuffer.h"
#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITPixelStatistics.h"
#include "Private/GL/vtkOITScreenStage.h"
#include "Private/GL/vtkOITShaderText.h"
#include "Private/GL/vtkOITTextureArray.h"
#include "Private/Peeling/vtkOITPeelRegion.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

class vtkOITCapabilities;
struct vtkOITFrame;
class vtkShaderProgram;

/**
 * What all peeling methods share in a frame: the state of each pixel from peel to peel
 * (vtkOITPeelStateFS.glsl says which layers), the depth buffer that masks what is peeled, and
 * the stages on pixels: Resolve of the method, Mask, Composite, Reduce.
 *
 * Pixels are addressed as in the framebuffer, so that geometry passes rasterize to the last bit
 * what the opaque pass did. Only in bands (limited memory) the picture is shifted.
 */
class vtkOITPeelState
{
public:
  /// Which fragments the Mask lets the hardware reject, besides those of finished pixels.
  enum class MaskSide
  {
    Front, // nearer than the bounds: the depth test is GL_GEQUAL
    Back   // farther than the bounds: GL_LEQUAL
  };

  struct Layout
  {
    int Layers = 3;        // of the state, see vtkOITPeelStateFS.glsl
    bool HasBack = false;  // layer 3 is what was peeled from the back
    bool MasksBack = true; // then the sides of the Mask take turns
    // The first Gather reads the statistics alone, the first Resolve no layer but them: only they
    // are cleared.
    bool StartsInResolve = false;
  };

  /// Whether shaders of this frame read and write the state in place, as colour buffers.
  ///@{
  static bool CanWorkInPlace(const vtkOITFrame& frame);
  static bool CanWorkInPlace(const vtkOITCapabilities& capabilities);
  ///@}

  /// Bytes per pixel of the state and of the depth buffers.
  static int GetBytesPerPixel(const vtkOITFrame& frame, const Layout& layout);

  /// Starts the pixels of `band`: nothing peeled, everything inside the bounds. Viewport and
  /// scissor are set for drawing into layers. `storage` has the band and the pixel that becomes
  /// texel (0, 0).
  vtkOITFailure Begin(const vtkOITFrame& frame, const vtkOITRectangle& band,
    const vtkOITRectangle& storage, const Layout& layout, double transmittanceThreshold,
    bool countsPixels);

  /// Binds textures of the method for a geometry pass, under the depth test against opaque geometry
  /// until there is a Mask, then under that. `clear` clears them, where they will be read.
  vtkOITFailure BindForGather(vtkOITFramebuffer& framebuffer,
    const std::vector<vtkOITAttachment>& colors, const std::function<void()>& clear);

  /// Draws all pixels that are not finished with the method's Resolve stage.
  /// The text has what AddResolve() adds.
  vtkOITFailure Resolve(vtkOITScreenStage& stage,
    const std::function<vtkOITShaderText()>& getFragmentShader,
    const std::function<void(vtkShaderProgram*)>& setUniforms);

  /// Draws the Mask of the region after this peel; counts the pixels that are not finished.
  vtkOITFailure Mask(std::size_t peel);

  /// Where pixels are left to peel. Gather and Mask are limited to it, Resolve is in place.
  vtkOITPeelRegion& GetRegion() { return this->Region; }

  /// After Gather of the first peel, which has noted what it had no room for as lost: whether
  /// there is nothing of that. Waits for it.
  vtkOITFailure IsFirstPeelComplete(bool& isComplete);

  /// Draws over the target of the frame, which is bound for output. By a stage of the method, when
  /// it has what is peeled in another form.
  ///@{
  vtkOITFailure Composite();
  vtkOITFailure Composite(vtkOITOutputStage& stage,
    const std::function<vtkOITShaderText()>& getFragmentShader,
    const std::function<void(vtkShaderProgram*)>& setUniforms);
  ///@}
  vtkOITFailure Reduce(vtkOITPixelStatistics::Result& result);

  /// Binds the state to its texture unit and sets the uniform oitState.
  void BindFor(vtkShaderProgram* program) const;

  /// For Gather stages that test against opaque geometry themselves once there is a Mask, because
  /// they do not know the farthest fragment in front of it: sets the uniforms oitTestsDepth, which
  /// is 2 once there is a Mask, 1 as long as the hardware does it, and 0 where nothing is in the way,
  /// oitOpaqueDepth and oitDepthBits. With `always` the depth can be read before there is a Mask,
  /// too: it is attached then, and not written.
  void SetDepthTest(vtkShaderProgram* program, bool always) const;

  /// The pixel of the framebuffer that is texel (0, 0), and the texels.
  int GetX() const { return this->Storage.X; }
  int GetY() const { return this->Storage.Y; }
  int GetWidth() const { return this->Storage.Width; }
  int GetHeight() const { return this->Storage.Height; }
  /// The texture array that Resolve has written last.
  const vtkOITTextureArray& GetArray() const { return this->Arrays[this->Current]; }

  std::int64_t GetSizeInBytes() const;
  void Release();

private:
  void SetScissorOfResolve() const;
  void AddResolve(vtkOITShaderText& text) const;

  const vtkOITFrame* Frame = nullptr;
  vtkOITRectangle Band;
  vtkOITRectangle Storage;
  Layout TheLayout;
  vtkOITPeelRegion Region;
  double TransmittanceThreshold = 0.0;
  bool InPlace = false;
  bool HasMask = false;
  MaskSide Side = MaskSide::Front; // of the Mask

  std::array<vtkOITTextureArray, 2> Arrays; // the second one is not used in place
  int Current = 0;
  vtkOITTextureArray MaskDepth;
  vtkOITPixelStatistics Statistics;
  vtkOITPixelStatistics::Result Reduced;
  bool IsReduced = false; // and has not changed since
  vtkOITDepthCopy OpaqueDepth;
  std::array<vtkOITFramebuffer, 2> StateFramebuffers;
  vtkOITFramebuffer MaskFramebuffer;
  std::array<vtkOITScreenStage, 2> MaskStages; // one for each side
  vtkOITOutputStage CompositeStage;
};

#endif
