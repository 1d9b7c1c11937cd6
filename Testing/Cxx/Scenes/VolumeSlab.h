// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Volumes of constant density that cover a rig's viewport between two window depths, and what a ray
 * through them and through quads gives: by the law of Beer and Lambert each piece between two quads
 * is a layer of opacity 1 - (1 - opacity)^(length / unit).
 */

#ifndef VolumeSlab_h
#define VolumeSlab_h

#include "Rig/Layer.h"
#include "Rig/Rig.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkOpenGLGPUVolumeRayCastMapper;
class vtkVolume;

namespace vtkOITTest
{
/// How far a picture may be off: of 40 float32 samples and their opacity tables, beside the rounding of
/// fragments.
constexpr Tolerance OfSamples = { 2e-4, 2e-4 };

/// Colours and opacities of quads.
///@{
const glm::vec4 Red(1.0f, 0.0f, 0.0f, 0.5f);
const glm::vec4 Green(0.0f, 1.0f, 0.0f, 0.4f);
const glm::vec4 Blue(0.0f, 0.0f, 1.0f, 0.3f);
///@}

struct Slab
{
  float Nearest = 0.3f; // window depths
  float Farthest = 0.7f;
  glm::vec3 Color{ 1.0f, 0.6f, 0.2f };
  float Opacity = 0.5f; // of a world length of 1
  int Samples = 40;     // of each ray
  float X0 = -2.0f;     // world coordinates of its sides
  float X1 = 2.0f;

  double GetSampleDistance() const
  {
    // The last sample lies half a step before the far face, so that their number is certain.
    return 2.0 * (this->Farthest - this->Nearest) / (this->Samples + 0.5);
  }
  /// The depth up to which the samples stand for the density.
  double GetEnd() const { return this->Nearest + 0.5 * this->Samples * this->GetSampleDistance(); }
};

/// The volume of a slab with a mapper of its own, that of GetMapper().
vtkSmartPointer<vtkVolume> MakeSlab(const Slab& slab);
vtkOpenGLGPUVolumeRayCastMapper* GetMapper(vtkVolume* volume);

/// Puts a volume into the rig's renderer, and where that has a chain of passes, its volumetric pass into
/// ours.
///@{
void AddVolume(Rig& rig, vtkVolume* volume);
vtkVolume* AddSlab(Rig& rig, const Slab& slab);
///@}

/// The layers, and the pieces of the slabs between them. Slabs do not overlap.
std::vector<Layer> PutBetween(const std::vector<Layer>& layers, const std::vector<Slab>& slabs);
}

#endif
