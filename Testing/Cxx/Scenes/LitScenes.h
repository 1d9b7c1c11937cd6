// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Crossing translucent props of one material under a camera in perspective.
 */

#ifndef LitScenes_h
#define LitScenes_h

#include <functional>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace vtkOITTest
{
/// What a prop is made of and how it is drawn: changes one with normals, texture coordinates and
/// scalars on its points and cells, none of which are used.
struct LitMaterial
{
  const char* Name;
  std::function<void(vtkActor*, vtkPolyData*)> Apply;
};
/// The first one reflects lights.
const std::vector<LitMaterial>& GetLitMaterials();

/// Two spheres through each other and a bent sheet, in front of the camera of the renderer.
void AddLitScene(vtkRenderer* renderer, const LitMaterial& material);
}

#endif
