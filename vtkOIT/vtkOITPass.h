// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITPass
 * @brief   base class of all order-independent transparency passes
 *
 * A vtkOITPass draws the translucent props of a renderer. It goes where VTK's own translucent
 * passes go: into vtkRenderStepsPass::SetTranslucentPass(), into a vtkSequencePass given to
 * vtkRenderer::SetPass(), or into an existing renderer through vtkOITRendererHook. The constructor
 * sets a delegate that draws the props (vtkTranslucentPass), so a new pass is ready to use.
 *
 * One frame, for every subclass:
 *
 * 1. Find the translucent props and the screen rectangle that their bounds can touch. With nothing
 *    translucent, or nothing on screen, return at once: no geometry pass, no memory.
 * 2. Ask whether the context and the framebuffer can do this method. If not, report in one line
 *    what is missing, and let the best exact method draw that can: the A-buffer, else dual depth
 *    peeling. GetAlgorithmName() tells which one did. Where neither can, the delegate blends the
 *    props unsorted, and GetExact() is false.
 * 3. The method of the subclass draws: geometry passes that write only to the pass's own
 *    storage, then a resolve that composites over what the framebuffer holds,
 *    `C = C_layers + T C_dst`, `A = (1-T) + T A_dst`, inside the rectangle only.
 * 4. All OpenGL state is left as it was found.
 *
 * Props that no method can sort are blended as a whole, with a warning, and GetExact() is false:
 * those that say that they have nothing translucent and draw it, as representations of widgets do,
 * those that draw without vtkOpenGLRenderPass, which a trial finds when they first appear, and
 * emissive Gaussians where the A-buffer does not sort their light, and with previews. Each is drawn in
 * its place: over all props with a farther centre of their bounds, and under all others, which are
 * sorted among themselves.
 *
 * Volumes in the view are drawn in their order along each ray, before, between or behind the
 * translucent props, where the pass may draw them: see VolumetricPass and docs/volumes.md. Drawn by
 * somebody else over translucent props that they overlap, they make GetExact() false.
 *
 * Opaque geometry must be in the bound framebuffer, with its depth, before Render() is called.
 *
 * @sa vtkOITABufferPass vtkOITRendererHook vtkOITPassFactory
 */

#ifndef vtkOITPass_h
#define vtkOITPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h" // for the delegate

#include <memory> // for the private parts
#include <string> // for GetMissingCapability
#include <vector> // for the props

class vtkOITCapabilities;
class vtkOITDelegate;
class vtkOITEngine;
class vtkOITVolumes;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkWindow;
struct vtkOITFrame;
struct vtkOITPlan;
struct vtkOITSettings;
struct vtkOITStatistics;

class VTKOIT_EXPORT vtkOITPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkOITPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* state) override;

  /// The same with another pass for the volumes than VolumetricPass, for this frame; nullptr when
  /// somebody else draws them afterwards. For those who put the pass somewhere, as
  /// vtkOITRendererHook does.
  void RenderWithVolumes(const vtkRenderState* state, vtkRenderPass* volumetricPass);

  /// Frees what the pass holds on the window's context. Call it, or destroy the pass, before the
  /// window is destroyed; a renderer does so for the passes it was given.
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// The delegate that draws the translucent props once per geometry pass. Default: a
  /// vtkTranslucentPass. nullptr is an error at render time; a vtkOITPass is refused.
  ///@{
  virtual void SetTranslucentPass(vtkRenderPass* pass);
  vtkRenderPass* GetTranslucentPass();
  ///@}

  /// The delegate that draws the volumes, once, where they lie between, before or behind the
  /// translucent props: for chains of passes, in the place of a volumetric pass of their own, e.g. a
  /// vtkVolumetricPass. Default: nullptr, somebody else draws volumes over the translucent props.
  /// vtkOITRendererHook does not use it: the renderer's UseDepthPeelingForVolumes decides. A
  /// vtkOITPass is refused.
  ///@{
  virtual void SetVolumetricPass(vtkRenderPass* pass);
  vtkRenderPass* GetVolumetricPass();
  ///@}

  /// Name of the algorithm, as in the literature, that drew the last frame: that of the subclass,
  /// of the method that took over, or "unsorted blending".
  std::string GetAlgorithmName() const;

  /// Empty when this method runs in the window's context, otherwise one line that says what is
  /// missing. The window's context must have been created (Render() called once).
  std::string GetMissingCapability(vtkOpenGLRenderWindow* window);

  /// Layers behind a transmittance of at most this may be skipped: they change a colour by no more
  /// than that. In [0, 1], default 1/512, half a step of 8 bits; 0 skips nothing but what is behind
  /// an opacity of 1. Peeling methods spend no peel on such layers; the A-buffer does not composite
  /// them in lists that are long (more than 32) or have coincident fragments, nor in multisampled
  /// windows; weighted previews skip nothing. GetErrorBound() is the
  /// largest transmittance in front of what was skipped.
  ///@{
  virtual void SetTransmittanceThreshold(double threshold);
  vtkGetMacro(TransmittanceThreshold, double);
  ///@}

  /// Meaning as in vtkRenderer: the largest number of geometry passes spent on peeling, 0 for no
  /// limit (default). Methods that do not peel need no limit.
  ///@{
  virtual void SetMaximumNumberOfPeels(int peels);
  vtkGetMacro(MaximumNumberOfPeels, int);
  ///@}

  /// Meaning as in vtkRenderer: peeling stops when fewer than this share of the viewport's pixels
  /// changed; [0, 0.5], default 0 (exact). Methods that do not peel have nothing to stop.
  ///@{
  virtual void SetOcclusionRatio(double ratio);
  vtkGetMacro(OcclusionRatio, double);
  ///@}

  /// Hard limit in bytes for the storage of the pass on the context, 0 (default) for no limit of
  /// its own beyond what the context offers. Under the limit the frame stays exact and is
  /// rendered in bands. At least 1 MiB when not 0.
  ///@{
  virtual void SetMaximumBufferSize(vtkTypeInt64 bytes);
  vtkGetMacro(MaximumBufferSize, vtkTypeInt64);
  ///@}

  /// How colour and opacity of a fragment are stored until they are blended.
  enum FragmentPrecisionType
  {
    HALF = 0, ///< half floats; an error of at most 2^-11 of each colour and opacity stored
    FLOAT = 1 ///< floats, as they are; for high dynamic range, negative colours
  };

  /// HALF (default) or FLOAT: what is at least kept. Depth peeling, bucket peeling and the weighted
  /// previews sum up in float32 with either. vtkOITMultiLayerPeelingPass refuses FLOAT. What is
  /// blended accumulates in float32 with all.
  ///@{
  virtual void SetFragmentPrecision(int precision);
  vtkGetMacro(FragmentPrecision, int);
  void SetFragmentPrecisionToHalf() { this->SetFragmentPrecision(HALF); }
  void SetFragmentPrecisionToFloat() { this->SetFragmentPrecision(FLOAT); }
  ///@}

  /// What fragments of one depth become, such as those of an overlay with the vertices of the surface
  /// that it lies on.
  enum CoincidentLayersType
  {
    MEAN = 0,       ///< one layer of the mean colour, whatever the order of drawing
    LAST_ON_TOP = 1 ///< blended in the order of drawing: what is drawn last lies on top
  };

  /// MEAN (default): opacity `1 - prod(1 - A)`, colour the mean weighted by opacity. LAST_ON_TOP: over
  /// each other in the order of OpenGL's blending, that of the renderer's props and of the triangles of
  /// a mesh, the same in all exact methods. Weighted previews know no layers.
  ///
  /// LAST_ON_TOP costs next to nothing where shaders can read the framebuffer. Otherwise, and in
  /// multisampled windows, the A-buffer uses GL_ARB_fragment_shader_interlock, or 16 bytes more for each
  /// fragment; without the interlock it leaves frames with composite data, glyphs and assemblies to dual
  /// depth peeling. Methods that peel then use GL_ARB_draw_buffers_blend, multi-layer peeling the
  /// interlock.
  ///@{
  virtual void SetCoincidentLayers(int rule);
  vtkGetMacro(CoincidentLayers, int);
  void SetCoincidentLayersToMean() { this->SetCoincidentLayers(MEAN); }
  void SetCoincidentLayersToLastOnTop() { this->SetCoincidentLayers(LAST_ON_TOP); }
  ///@}

  /// Sets the statistics to those of a frame without translucent props. Render() does so first;
  /// vtkOITRendererHook does so for frames in which the renderer finds nothing translucent, and so
  /// does not render the pass.
  void ResetStatistics();

  /// Sets the statistics to those of a frame with translucent props that the pass was not asked to
  /// draw, as before the first frame: not exact, no passes. vtkOITRendererHook does so.
  void SetNotAsked();

  /// Statistics of the last Render().
  ///@{
  /// How often the delegate drew the translucent props.
  int GetNumberOfGeometryPasses() const;
  /// Fragments captured over all pixels; negative when the pass cannot know.
  vtkTypeInt64 GetNumberOfFragments() const;
  /// Largest number of fragments of one pixel; negative when the pass cannot know.
  int GetMaximumDepthComplexity() const;
  /// Bytes that the pass holds on the context.
  vtkTypeInt64 GetBufferSizeInBytes() const;
  /// True when nothing was dropped or approximated.
  bool GetExact() const;
  /// 0 when exact, otherwise a bound on the colour error (colours in [0,1]).
  double GetErrorBound() const;
  ///@}

protected:
  /// `engine`: draws by the method of the subclass; nullptr for the best of all.
  explicit vtkOITPass(std::unique_ptr<vtkOITEngine> engine);
  ~vtkOITPass() override;

  /// What GetAlgorithmName() is before the first frame, and after one without translucent props.
  virtual std::string GetOwnAlgorithmName() const;

  /// The properties as one value, for a context.
  virtual vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const;

  /// Step 3 of a frame. Default: one job, all props by the subclass's engine.
  virtual vtkOITPlan MakePlan(const vtkOITFrame& frame, const vtkOITSettings& settings);

  vtkOITEngine* GetEngine() const;
  const vtkOITStatistics& GetStatistics() const;

  /// For setters: whether a number is in [low, high]; otherwise an error that names the property.
  bool IsInRange(const char* property, double value, double low, double high);
  /// For setters of properties with named values from 0 to `last`.
  bool IsNamedValue(const char* property, int value, int last, const char* names);

  vtkSmartPointer<vtkRenderPass> TranslucentPass;
  vtkSmartPointer<vtkRenderPass> VolumetricPass;
  double TransmittanceThreshold = 1.0 / 512.0;
  int MaximumNumberOfPeels = 0;
  double OcclusionRatio = 0.0;
  vtkTypeInt64 MaximumBufferSize = 0; // bytes
  int FragmentPrecision = HALF;
  int CoincidentLayers = MEAN;

private:
  vtkOITPass(const vtkOITPass&) = delete;
  void operator=(const vtkOITPass&) = delete;

  void DrawUnsorted(const vtkRenderState* state, const std::string& reason);
  void Report();

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
