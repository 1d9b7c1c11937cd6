// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Frames with many fragments: faint layers over the whole viewport.
 */

#ifndef DeepStack_h
#define DeepStack_h

#include "Rig/Rig.h"

#include <string>

namespace vtkOITTest
{
/// Renders so many layers three times and checks the picture and what the pass reports: exact, as
/// many fragments as pixels times layers, and the layers as depth complexity.
void CheckDeepStack(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  int numberOfLayers, int numberOfFrames = 3);
}

#endif
