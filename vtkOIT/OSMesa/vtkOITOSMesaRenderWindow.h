// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITOSMesaRenderWindow
 * @brief   a render window that lives in memory and draws with OSMesa
 *
 * For VTK 9.1 to 9.3 as distributions build them, for X only; later versions of VTK have such a
 * window of their own. vtkOITHeadless::Initialize() makes vtkRenderWindow::New() give this class.
 *
 * 1. The first Render() makes an OpenGL context of OSMesa: core profile, the highest version that
 *    the library has (4.5 with Mesa's llvmpipe).
 * 2. VTK draws into its own framebuffer objects; nothing is shown or copied elsewhere.
 *    SetShowWindow() and SetUseOffScreenBuffers() are accepted and change nothing in the picture.
 * 3. Pixels are read with vtkWindowToImageFilter, GetPixelData() and the like, as from any window.
 *
 * When no context can be made, or the size is more than OpenGL allows (16384 by 16384 pixels with
 * llvmpipe), Render() reports one error that names the reason and draws nothing.
 *
 * Requires libOSMesa.so.8 at run time and Linux.
 *
 * @sa vtkOITHeadless
 */

#ifndef vtkOITOSMesaRenderWindow_h
#define vtkOITOSMesaRenderWindow_h

#include "vtkOITOSMesaModule.h" // for the export macro
#include "vtkOpenGLRenderWindow.h"

#include <memory> // for the internals

class VTKOITOSMESA_EXPORT vtkOITOSMesaRenderWindow : public vtkOpenGLRenderWindow
{
public:
  static vtkOITOSMesaRenderWindow* New();
  vtkTypeMacro(vtkOITOSMesaRenderWindow, vtkOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Makes the context if there is none. Finalize() undoes it; both may be called repeatedly.
  void Initialize() override;
  void Finalize() override;

  /// Drawing; without effect, but for one error, where there is no context.
  ///@{
  void Render() override;
  void Start() override;
  void Frame() override;
  void End() override;
  ///@}

  /// The context of this window, current in the calling thread. They do nothing without a context.
  ///@{
  void MakeCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  ///@}

  /// Windows that were given each other by SetSharedRenderWindow() share textures and buffers.
  bool GetPlatformSupportsRenderWindowSharing() override { return true; }

  /// The OSMesaContext, nullptr before the first Render().
  void* GetGenericContext() override;

  /// "OSMesa".
  const char* GetRenderingBackend() override { return "OSMesa"; }
  /// OpenGL's vendor, renderer, version and extensions, after a line that names OSMesa.
  const char* ReportCapabilities() override;
  /// Always 0: OSMesa draws on the CPU.
  vtkTypeBool IsDirect() override { return 0; }
  /// Always 1920 by 1080: there is no screen.
  int* GetScreenSize() override;

  /// Window-system requests that have no meaning here and no effect.
  ///@{
  void SetFullScreen(vtkTypeBool) override {}
  void WindowRemap() override;
  ///@}

  /// Reading and writing depth and colour; VTK_ERROR before the first frame.
  ///@{
  using vtkOpenGLRenderWindow::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  using vtkOpenGLRenderWindow::SetZbufferData;
  int SetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  using vtkOpenGLRenderWindow::SetPixelData;
  int SetPixelData(
    int x1, int y1, int x2, int y2, unsigned char* data, int front, int right = 0) override;
  using vtkOpenGLRenderWindow::SetRGBAPixelData;
  int SetRGBAPixelData(
    int x1, int y1, int x2, int y2, float* data, int front, int blend = 0, int right = 0) override;
  using vtkOpenGLRenderWindow::SetRGBACharPixelData;
  int SetRGBACharPixelData(int x1, int y1, int x2, int y2, unsigned char* data, int front,
    int blend = 0, int right = 0) override;
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkOITOSMesaRenderWindow();
  ~vtkOITOSMesaRenderWindow() override;

  void CreateAWindow() override;
  void DestroyWindow() override;
  /// Nothing: there is no hardware to blit to.
  void BlitDisplayFramebuffersToHardware() override {}
  int ReadPixels(
    const vtkRecti& rectangle, int front, int format, int type, void* data, int right = 0) override;

private:
  vtkOITOSMesaRenderWindow(const vtkOITOSMesaRenderWindow&) = delete;
  void operator=(const vtkOITOSMesaRenderWindow&) = delete;

  /// True when a frame can be drawn now; otherwise it has reported why not.
  bool Prepare();
  /// True when there is a context with something drawn in it.
  bool HasFrame();

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
