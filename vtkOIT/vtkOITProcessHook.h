// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITProcessHook
 * @brief   draws the translucent props of every renderer of a process
 *
 * For applications that know nothing of vtkOIT. Install() puts an object factory in front of VTK's,
 * which creates nothing of its own: it lets VTK create renderers and render windows, and hooks what
 * comes out. A vtkRenderer has a pass from its creation on; a window gives one to all of its
 * renderers before each frame, also to those of an application's own class. Where a renderer has a
 * chain of VTK's passes, its translucent slots are taken.
 *
 * The application does not notice: UseDepthPeeling of a renderer is switched on only during a frame,
 * and a renderer that cannot be reached (a chain of passes that hides its translucent pass) is drawn
 * as without vtkOIT. Renderers that have a pass by vtkOITRendererHook::Install() keep it.
 *
 * Environment, read by InstallByEnvironment(), which the library in VTK_AUTOLOAD_PATH calls:
 * VTKOIT_METHOD, VTKOIT_AUTOLOAD and VTKOIT_LOG; see docs/applications.md.
 *
 * Cost: a comparison of names for each object that VTK makes by its factories, and a look at the
 * renderers of a window before each frame.
 *
 * @sa vtkOITRendererHook vtkOITPassFactory
 */

#ifndef vtkOITProcessHook_h
#define vtkOITProcessHook_h

#include "vtkOITModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for those that were reached

#include <string> // for the method
#include <vector> // for those that were reached

class vtkRenderWindow;
class vtkRenderer;

class VTKOIT_EXPORT vtkOITProcessHook : public vtkObject
{
public:
  static vtkOITProcessHook* New();
  vtkTypeMacro(vtkOITProcessHook, vtkObject);

  /// All renderers that are made from now on, and all in windows that are made from now on, draw by
  /// the method of that name. Called again with another one, it changes the method of all that were
  /// reached, from their next frame on, and of those to come. False, with one line of error, when
  /// there is no such method.
  static bool Install(const std::string& methodName = "auto");

  /// Gives back every renderer that was reached, and reaches no more, until Install() is called again:
  /// that takes these, too. False when nothing was installed.
  static bool Uninstall();

  /// Whether renderers and windows that are made while nothing is installed are remembered: Install()
  /// reaches those as well, and ReachWindow() lets it reach that window. For applications in which
  /// users switch a method on and off. Default off.
  ///@{
  static void SetWatch(bool watch);
  static bool GetWatch();
  ///@}

  /// The name of the installed method, empty when nothing is installed.
  static std::string GetInstalledMethod();

  /// As Install(), by the environment. A value that is wrong is told in one line on standard error,
  /// and nothing is installed then. Whether something was.
  static bool InstallByEnvironment();

  /// Whether InstallByEnvironment() would install. A wrong value is told once in a process.
  static bool CheckEnvironment();

  /// A window that was made before Install(): its renderers are reached before its next frame. Does
  /// nothing when nothing is installed.
  static void ReachWindow(vtkRenderWindow* window);

  /// Properties of the passes of all renderers, of those that were reached already, too: see
  /// vtkOITPass, which has the ranges and defaults. They stay after Uninstall(). False, with one line
  /// of error, for a value that a pass refuses.
  ///@{
  static bool SetTransmittanceThreshold(double threshold);
  static double GetTransmittanceThreshold();
  static bool SetMaximumBufferSize(vtkTypeInt64 bytes);
  static vtkTypeInt64 GetMaximumBufferSize();
  ///@}

  /// Whether a renderer's UseDepthPeeling decides who draws its frames: with it off, VTK does.
  /// Default off. For renderers that are reached from now on.
  ///@{
  static void SetRespectDepthPeeling(bool respect);
  static bool GetRespectDepthPeeling();
  ///@}

  /// Whether standard error gets a line for each renderer that is reached from now on, and one of
  /// statistics at the end of the process. Default off.
  ///@{
  static void SetLog(bool log);
  static bool GetLog();
  ///@}

protected:
  vtkOITProcessHook() = default;
  ~vtkOITProcessHook() override = default;

private:
  static void ReachRenderer(vtkRenderer* renderer, const std::string& way);
  static void PutFactory();
  static void ReachRenderersOf(vtkRenderWindow* window);
  static void Reach(vtkRenderer* renderer, const std::string& way);
  static std::vector<vtkSmartPointer<vtkRenderer>> GetReached();
  class Factory;
  class WindowObserver;

  vtkOITProcessHook(const vtkOITProcessHook&) = delete;
  void operator=(const vtkOITProcessHook&) = delete;
};

#endif
