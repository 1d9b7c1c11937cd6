// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Textures with alpha: each texel has its own opacity, and texels of alpha 0 are not there.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <array>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 40;
constexpr int Height = 32;

/// Four texels, one for each quarter of a quad: bottom left, bottom right, top left, top right.
using Texels = std::array<std::array<unsigned char, 4>, 4>;

void AddTexture(vtkActor* actor, const Texels& texels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (const auto& texel : texels)
  {
    colors->InsertNextTypedTuple(texel.data());
  }
  image->GetPointData()->SetScalars(colors);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  texture->SetColorModeToDirectScalars();
  actor->SetTexture(texture);

  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  coordinates->InsertNextTuple2(0.0, 0.0);
  coordinates->InsertNextTuple2(1.0, 0.0);
  coordinates->InsertNextTuple2(1.0, 1.0);
  coordinates->InsertNextTuple2(0.0, 1.0);
  vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))
    ->GetPointData()
    ->SetTCoords(coordinates);
}

glm::vec4 GetTexel(const Texels& texels, int x, int y)
{
  const auto& texel = texels[(x < Width / 2 ? 0 : 1) + (y < Height / 2 ? 0 : 2)];
  return glm::vec4(texel[0], texel[1], texel[2], texel[3]) / 255.0f;
}
}

int TestTextures(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      const Texels front{ { { { 255, 0, 0, 0 } }, { { 200, 30, 10, 64 } }, { { 10, 220, 30, 128 } },
        { { 250, 240, 20, 255 } } } };
      const Texels back{ { { { 20, 20, 240, 128 } }, { { 0, 255, 0, 0 } }, { { 90, 10, 200, 192 } },
        { { 20, 200, 200, 32 } } } };
      const glm::vec4 white(1.0f, 1.0f, 1.0f, 1.0f);
      for (const bool frontFirst : { true, false })
      {
        Rig rig(setup, Width, Height);
        for (const bool isFront : { frontFirst, !frontFirst })
        {
          AddTexture(rig.AddQuad({ isFront ? 0.25f : 0.75f, white }), isFront ? front : back);
        }
        report.Compare(
          frontFirst ? "front drawn first" : "back drawn first", rig.Render(),
          [&](int x, int y)
          {
            return ReferenceCompositor::Composite(
              { { 0.25f, GetTexel(front, x, y) }, { 0.75f, GetTexel(back, x, y) } },
              rig.GetBackground());
          },
          ReferenceCompositor::RoundingBoundOfAnyStack(2, setup.FragmentStorage));
      }
    });
}
