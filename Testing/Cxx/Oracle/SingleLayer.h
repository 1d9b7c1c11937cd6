// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The known answer for a translucent prop with at most one fragment in each pixel, whatever its
 * mapper does to make it: with B the picture without the prop and E the picture with the prop made
 * opaque, the translucent picture is a E + (1 - a) B. Where something hides the prop, E is B.
 */

#ifndef SingleLayer_h
#define SingleLayer_h

#include "Rig/Rig.h"

#include <string>

class vtkActor;

namespace vtkOITTest
{
/// Renders the prop (of the rig's renderer) absent, opaque and with this opacity, and compares.
/// At least so many pixels must show it, and so many must not.
void CheckSingleLayer(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  vtkActor* actor, float opacity, int minimumVisible = 20, int minimumHidden = 20);
}

#endif
