// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITRendererHook
 * @brief   puts a vtkOITPass into a renderer that already exists
 *
 * Install() makes the renderer draw its translucent props with the given pass. The rest of the
 * renderer's pipeline stays VTK's: selection, SSAO, FXAA, volumes and overlays. It works for every
 * vtkOpenGLRenderer, also for subclasses of applications (PyVista, F3D, ParaView).
 *
 * UseDepthPeeling of the renderer is switched on. Its MaximumNumberOfPeels and OcclusionRatio are
 * ignored while a pass is installed; the pass has such properties of its own. Uninstall() restores
 * what Install() found.
 *
 * UseDepthPeelingForVolumes is switched on, too: volumes are drawn between the translucent props, in
 * the order along each ray. Switched off after Install(), they are drawn over the translucent props,
 * and GetExact() of the pass is false where they overlap.
 *
 * @sa vtkOITPass
 */

#ifndef vtkOITRendererHook_h
#define vtkOITRendererHook_h

#include "vtkOITModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the record

class vtkOITHookRecord;
class vtkOITPass;
class vtkRenderer;

class VTKOIT_EXPORT vtkOITRendererHook : public vtkObject
{
public:
  static vtkOITRendererHook* New();
  vtkTypeMacro(vtkOITRendererHook, vtkObject);

  /// Draws the translucent props of the renderer with the pass from the next frame on, instead of
  /// a pass installed before. False, with one line of error, when the renderer is not an OpenGL
  /// renderer or an argument is nullptr.
  static bool Install(vtkRenderer* renderer, vtkOITPass* pass);

  /// Gives the renderer back as Install() found it; false when nothing was installed.
  static bool Uninstall(vtkRenderer* renderer);

  /// The installed pass, or nullptr.
  static vtkOITPass* GetInstalledPass(vtkRenderer* renderer);

protected:
  vtkOITRendererHook() = default;
  ~vtkOITRendererHook() override = default;

private:
  friend class vtkOITProcessHook;
  /// As Install(), in an application that did not ask for it: no warnings, UseDepthPeeling is on
  /// only during a frame, and each frame is recorded.
  static bool InstallUnasked(
    vtkRenderer* renderer, vtkOITPass* pass, const std::shared_ptr<vtkOITHookRecord>& record);
  /// Observes the renderer's frames again, when an application has removed all observers.
  static void Observe(vtkRenderer* renderer);
  static bool IsInstalledUnasked(vtkRenderer* renderer);

  vtkOITRendererHook(const vtkOITRendererHook&) = delete;
  void operator=(const vtkOITRendererHook&) = delete;
};

#endif
