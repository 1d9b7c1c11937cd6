// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/VolumeSlab.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vtkOITTest
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolume> MakeSlab(const Slab& slab)
{
  constexpr int side = 8; // voxels
  const double low[3] = { slab.X0, -2.0, DepthToZ(slab.Farthest) };
  const double high[3] = { slab.X1, 2.0, DepthToZ(slab.Nearest) };
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, side);
  image->SetOrigin(low);
  image->SetSpacing((high[0] - low[0]) / (side - 1), (high[1] - low[1]) / (side - 1),
    (high[2] - low[2]) / (side - 1));
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::memset(image->GetScalarPointer(), 100, side * side * side);

  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(slab.GetSampleDistance()));
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, slab.Opacity);
  opacity->AddPoint(255.0, slab.Opacity);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, slab.Color.r, slab.Color.g, slab.Color.b);
  color->AddRGBPoint(255.0, slab.Color.r, slab.Color.g, slab.Color.b);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  property->SetInterpolationTypeToLinear();
  return volume;
}

//------------------------------------------------------------------------------
vtkOpenGLGPUVolumeRayCastMapper* GetMapper(vtkVolume* volume)
{
  return vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
}

//------------------------------------------------------------------------------
void AddVolume(Rig& rig, vtkVolume* volume)
{
  rig.Renderer->AddVolume(volume);
  // Mappers copy the depth as VTK can: from the format that its windows have.
  rig.SetTargetFormat(VTK_FLOAT, vtkTextureObject::Fixed32);
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(rig.Renderer->GetPass()))
  {
    steps->SetVolumetricPass(nullptr);
    rig.Pass->SetVolumetricPass(vtkNew<vtkVolumetricPass>());
  }
}

//------------------------------------------------------------------------------
vtkVolume* AddSlab(Rig& rig, const Slab& slab)
{
  const vtkSmartPointer<vtkVolume> volume = MakeSlab(slab);
  AddVolume(rig, volume);
  return volume;
}

//------------------------------------------------------------------------------
std::vector<Layer> PutBetween(const std::vector<Layer>& layers, const std::vector<Slab>& slabs)
{
  std::vector<Layer> all = layers;
  for (const Slab& slab : slabs)
  {
    std::vector<double> cuts{ slab.Nearest, slab.GetEnd() };
    for (const Layer& layer : layers)
    {
      if (layer.Depth > slab.Nearest && layer.Depth < slab.GetEnd())
      {
        cuts.push_back(layer.Depth);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    {
      if (cuts[i + 1] > cuts[i])
      {
        const double length = 2.0 * (cuts[i + 1] - cuts[i]);
        const auto opacity = static_cast<float>(1.0 - std::pow(1.0 - slab.Opacity, length));
        const auto depth = static_cast<float>(0.5 * (cuts[i] + cuts[i + 1]));
        all.push_back({ depth, glm::vec4(slab.Color, opacity) });
      }
    }
  }
  return all;
}
}
