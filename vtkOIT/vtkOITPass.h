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
 * 3. RenderTranslucent() of the subclass: geometry passes that write only to the pass's own
 *    storage, then a resolve that composites over what the framebuffer holds,
 *    `C = C_layers + T C_dst`, `A = (1-T) + T A_dst`, inside the rectangle only.
 * 4. All OpenGL state is left as it was found.
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

#include <memory> // for the capabilities
#include <string> // for GetMissingCapability

class vtkOITCapabilities;
class vtkOITFrame;
class vtkOpenGLRenderWindow;
class vtkWindow;

class VTKOIT_EXPORT vtkOITPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkOITPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* state) override;

  /// Frees what the pass holds on the window's context. Call it, or destroy the pass, before the
  /// window is destroyed; a renderer does so for the passes it was given.
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// The delegate that draws the translucent props once per geometry pass. Default: a
  /// vtkTranslucentPass. nullptr is an error at render time.
  ///@{
  virtual void SetTranslucentPass(vtkRenderPass* pass);
  vtkRenderPass* GetTranslucentPass();
  ///@}

  /// Name of the algorithm, as in the literature, that drew the last frame: that of the subclass,
  /// of the method that took over, or "unsorted blending".
  const char* GetAlgorithmName();

  /// Empty when this method runs in the window's context, otherwise one line that says what is
  /// missing. The window's context must have been created (Render() called once).
  std::string GetMissingCapability(vtkOpenGLRenderWindow* window);

  /// Meaning as in vtkRenderer: the largest number of geometry passes spent on peeling, 0 for no
  /// limit (default). Methods that do not peel ignore it.
  ///@{
  vtkSetClampMacro(MaximumNumberOfPeels, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfPeels, int);
  ///@}

  /// Meaning as in vtkRenderer: peeling stops when fewer than this share of the viewport's pixels
  /// changed; [0, 0.5], default 0 (exact). Methods that do not peel ignore it.
  ///@{
  vtkSetClampMacro(OcclusionRatio, double, 0.0, 0.5);
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

  /// HALF (default) or FLOAT. What is blended accumulates in float32 with either. Methods that
  /// keep no fragments ignore it.
  ///@{
  vtkSetClampMacro(FragmentPrecision, int, HALF, FLOAT);
  vtkGetMacro(FragmentPrecision, int);
  void SetFragmentPrecisionToHalf() { this->SetFragmentPrecision(HALF); }
  void SetFragmentPrecisionToFloat() { this->SetFragmentPrecision(FLOAT); }
  ///@}

  /// Sets the statistics to those of a frame without translucent props. Render() does so first;
  /// vtkOITRendererHook does so for frames in which the renderer finds nothing translucent, and so
  /// does not render the pass.
  void ResetStatistics();

  /// Statistics of the last Render().
  ///@{
  /// How often the delegate drew the translucent props.
  vtkGetMacro(NumberOfGeometryPasses, int);
  /// Fragments captured over all pixels; negative when the pass cannot know.
  vtkGetMacro(NumberOfFragments, vtkTypeInt64);
  /// Largest number of fragments of one pixel; negative when the pass cannot know.
  vtkGetMacro(MaximumDepthComplexity, int);
  /// Bytes that the pass holds on the context.
  vtkGetMacro(BufferSizeInBytes, vtkTypeInt64);
  /// True when nothing was dropped or approximated.
  vtkGetMacro(Exact, bool);
  /// 0 when exact, otherwise a bound on the colour error (colours in [0,1]).
  vtkGetMacro(ErrorBound, double);
  ///@}

protected:
  vtkOITPass();
  ~vtkOITPass() override;

  /// Step 3 of a frame. State is saved before and restored after.
  virtual void RenderTranslucent(vtkOITFrame& frame) = 0;

  /// Name of the subclass's algorithm, as in the literature.
  virtual const char* GetOwnAlgorithmName() = 0;

  /// Empty, or one line that says what the context lacks for this method.
  virtual std::string FindMissingCapability(const vtkOITCapabilities& capabilities) = 0;

  /// The same for the bound framebuffer of a frame. Default: nothing is missing.
  virtual std::string FindMissingInTarget(const vtkOITFrame& frame);

  /// One geometry pass: the delegate draws the frame's translucent props, with this pass among
  /// their vtkOpenGLRenderPass::RenderPasses(), so that their shaders are changed by it.
  void RenderGeometry(vtkOITFrame& frame);

  /// Empty when a pass can draw the frame, otherwise one line that says what is missing.
  static std::string FindMissing(vtkOITPass& pass, const vtkOITFrame& frame)
  {
    return pass.FindMissing(frame);
  }

  /// Lets another pass draw the frame's props, with this pass's delegate and FragmentPrecision, and
  /// adds its statistics to those of this pass. GetAlgorithmName() is that of the other pass.
  void RenderBy(vtkOITPass& pass, vtkOITFrame& frame);

  /// Of what drew the last frame; nullptr for the name of the subclass.
  void SetAlgorithmName(const char* name) { this->LastAlgorithmName = name; }

  vtkSmartPointer<vtkRenderPass> TranslucentPass;
  int MaximumNumberOfPeels = 0;
  double OcclusionRatio = 0.0;
  vtkTypeInt64 MaximumBufferSize = 0; // bytes
  int FragmentPrecision = HALF;

  int NumberOfGeometryPasses = 0;
  vtkTypeInt64 NumberOfFragments = 0;
  int MaximumDepthComplexity = 0;
  vtkTypeInt64 BufferSizeInBytes = 0;
  bool Exact = true;
  double ErrorBound = 0.0;

private:
  std::string FindMissing(const vtkOITFrame& frame);
  bool RenderByFallback(vtkOITFrame& frame, const std::string& reason);
  void RenderFrame(vtkOITFrame& frame);
  void RenderUnsorted(const vtkRenderState* state, const std::string& reason);
  void Report(const char* consequence, const std::string& reason);
  const vtkOITCapabilities& QueryCapabilities(vtkOpenGLRenderWindow* window);

  std::unique_ptr<vtkOITCapabilities> Capabilities; // of CapabilitiesWindow
  vtkOpenGLRenderWindow* CapabilitiesWindow = nullptr;
  std::string ReportedReason;           // so that each reason is reported once, not every frame
  vtkSmartPointer<vtkOITPass> Fallback; // of FallbackMethod, made when first needed
  const char* FallbackMethod = nullptr;
  const char* LastAlgorithmName = nullptr;

  vtkOITPass(const vtkOITPass&) = delete;
  void operator=(const vtkOITPass&) = delete;
};

#endif
