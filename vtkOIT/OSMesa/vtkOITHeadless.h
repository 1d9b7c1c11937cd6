// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITHeadless
 * @brief   render without a display: on the CPU, or by EGL
 *
 * Call Initialize() once, before the first render window is made:
 *
 * 1. With VTK 9.1 to 9.3 every vtkRenderWindow::New() gives a vtkOITOSMesaRenderWindow from then
 *    on, and every vtkRenderWindowInteractor::New() an interactor without a window system. The
 *    distribution's VTK, built for X, is used as it is: its OpenGL calls are redirected to
 *    libOSMesa.so.8, in whatever order the libraries were linked, loaded or imported.
 * 2. With VTK 9.4 and later VTK's own OSMesa window is chosen where libOSMesa.so.8 can be opened,
 *    otherwise VTK's EGL window, which draws on a GPU where its driver has EGL. The environment
 *    variable VTK_DEFAULT_OPENGL_WINDOW is set to the choice, for this process only; when it is
 *    vtkEGLRenderWindow already, OSMesa is not tried.
 *
 * No environment variable needs to be set. With VTK 9.1 to 9.3, windows on a screen cannot be made
 * in the same process after a successful call.
 *
 * @sa vtkOITOSMesaRenderWindow
 */

#ifndef vtkOITHeadless_h
#define vtkOITHeadless_h

#include "vtkOITOSMesaModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for the backend's name

class VTKOITOSMESA_EXPORT vtkOITHeadless : public vtkObject
{
public:
  static vtkOITHeadless* New();
  vtkTypeMacro(vtkOITHeadless, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Makes every render window of this process headless from now on. Returns true on success, and
   * at once when it succeeded before. On failure it reports one error that names the reason,
   * returns false and leaves everything as it was; it may be called again.
   */
  static bool Initialize();

  /// "OSMesa" or "EGL" after a successful Initialize(), empty before.
  static std::string GetBackendName();

protected:
  vtkOITHeadless() = default;
  ~vtkOITHeadless() override = default;

private:
  vtkOITHeadless(const vtkOITHeadless&) = delete;
  void operator=(const vtkOITHeadless&) = delete;
};

#endif
