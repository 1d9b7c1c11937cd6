// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITVolumeText_h
#define vtkOITVolumeText_h

#include <string>

/// Makes March (glsl/Volume) a part of the fragment shader of a volume mapper, before the mapper has
/// replaced its marks. `blendMode` is one of vtkVolumeMapper. False, and nothing is changed, when the
/// shader lacks a mark: then it is not VTK's.
bool vtkOITAddMarch(std::string& fragmentShader, int blendMode);

/// The texts that are added, with a mark of the top.
std::string vtkOITGetMarchText();

#endif
