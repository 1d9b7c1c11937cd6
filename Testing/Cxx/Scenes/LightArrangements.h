// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lights of all kinds.
 */

#ifndef LightArrangements_h
#define LightArrangements_h

#include <functional>
#include <vector>

class vtkRenderer;

namespace vtkOITTest
{
struct LightArrangement
{
  const char* Name;
  std::function<void(vtkRenderer*)> Add;
  bool IsForEachMaterial;
};
/// The first one is the headlight that VTK makes.
const std::vector<LightArrangement>& GetLightArrangements();
}

#endif
