// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITParaViewStart_h
#define vtkOITParaViewStart_h

#include "vtkOITParaViewSettingsModule.h" // for the export macro

/// What ParaView calls when it has loaded the plugin, in each process: hooks into the process, and in
/// a client makes the settings page and reaches the views that there are.
VTKOITPARAVIEWSETTINGS_EXPORT void vtkOITParaViewStart();

#endif
