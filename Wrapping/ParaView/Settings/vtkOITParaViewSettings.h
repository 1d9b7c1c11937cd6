// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITParaViewSettings
 * @brief   what ParaView's settings page Translucency says, in a process
 *
 * One object in each process of ParaView: the client, and every rank of a server. It hands what the
 * page says to vtkOITProcessHook, which reaches the renderers of views; the depth peeling of a
 * renderer is the switch of its view. The proxy of the page is in translucency.xml.
 *
 * The page keeps its values in ParaView's settings of the user; the defaults here hold until it exists.
 *
 * @sa vtkOITProcessHook
 */

#ifndef vtkOITParaViewSettings_h
#define vtkOITParaViewSettings_h

#include "vtkOITParaViewSettingsModule.h" // for the export macro
#include "vtkObject.h"

class VTKOITPARAVIEWSETTINGS_EXPORT vtkOITParaViewSettings : public vtkObject
{
public:
  /// The object of this process, with one reference more.
  static vtkOITParaViewSettings* New();
  vtkTypeMacro(vtkOITParaViewSettings, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The object of this process.
  static vtkOITParaViewSettings* GetInstance();

  /// Who draws, from the next frame of each view on: 0 ParaView, 1 (default) vtkOIT by its automatic
  /// choice, from 2 on by the exact method of that number, see GetMethodName(). Another number is
  /// refused, with an error.
  ///@{
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  ///@}

  /// The name for vtkOITPassFactory of a number; empty for 0, nullptr where there is no such method.
  static const char* GetMethodName(int method);

  /// The most memory for each view on its context, in MiB; 0 (default) for no limit of its own. See
  /// vtkOITPass::SetMaximumBufferSize().
  ///@{
  void SetBufferLimit(int mebibytes);
  vtkGetMacro(BufferLimit, int);
  ///@}

  /// See vtkOITPass::SetTransmittanceThreshold(): in [0, 1], default 1/512.
  ///@{
  void SetTransmittanceThreshold(double threshold);
  vtkGetMacro(TransmittanceThreshold, double);
  ///@}

  /// Reaches the renderers of a view (vtkPVView) that was made before the plugin was loaded.
  void ReachView(vtkObject* view);

  /// Reaches all views that are made from now on.
  void Start();

protected:
  vtkOITParaViewSettings() = default;
  ~vtkOITParaViewSettings() override = default;

  int Method = 1;
  int BufferLimit = 0; // MiB
  double TransmittanceThreshold = 1.0 / 512.0;

private:
  vtkOITParaViewSettings(const vtkOITParaViewSettings&) = delete;
  void operator=(const vtkOITParaViewSettings&) = delete;
};

#endif
