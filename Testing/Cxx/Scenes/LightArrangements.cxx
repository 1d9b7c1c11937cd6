// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/LightArrangements.h"

#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <cmath>

namespace vtkOITTest
{
namespace
{
vtkSmartPointer<vtkLight> AddLight(vtkRenderer* renderer, double x, double y, double z)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(0.6);
  renderer->AddLight(light);
  return light;
}

void AddMixedLights(vtkRenderer* renderer, int number)
{
  for (int i = 0; i < number; ++i)
  {
    const double angle = 2.4 * i;
    const auto light =
      AddLight(renderer, 1.5 * std::cos(angle), 1.5 * std::sin(angle), 0.8 + 0.2 * (i % 5));
    light->SetPositional(i % 3 != 0);
    light->SetIntensity(2.0 / number);
    light->SetConeAngle(i % 3 == 2 ? 35.0 : 180.0);
    light->SetExponent(1.0 + i % 4);
    light->SetColor(0.4 + 0.2 * (i % 4), 1.0 - 0.15 * (i % 5), 0.5 + 0.25 * (i % 3));
    light->SetAttenuationValues(1.0, 0.1 * (i % 3), 0.05 * (i % 4));
    if (i % 7 == 3)
    {
      light->SetLightTypeToCameraLight();
    }
    light->SetSwitch(i % 6 != 5);
  }
}
}

//------------------------------------------------------------------------------
const std::vector<LightArrangement>& GetLightArrangements()
{
  static const std::vector<LightArrangement> arrangements = {
    { "the headlight of VTK", [](vtkRenderer*) {}, true },
    { "a red headlight",
      [](vtkRenderer* r)
      {
        const auto light = AddLight(r, 0.0, 0.0, 1.0);
        light->SetLightTypeToHeadlight();
        light->SetColor(1.0, 0.3, 0.2);
      },
      false },
    { "a light kit",
      [](vtkRenderer* r)
      {
        vtkNew<vtkLightKit> kit;
        kit->AddLightsToRenderer(r);
      },
      false },
    { "a distant light", [](vtkRenderer* r) { AddLight(r, 2.0, 1.0, 0.5); }, false },
    { "a headlight and one that is off",
      [](vtkRenderer* r)
      {
        AddLight(r, 0.0, 0.0, 1.0)->SetLightTypeToHeadlight();
        AddLight(r, 1.0, 2.0, 0.0)->SwitchOff();
      },
      false },
    { "a near light", [](vtkRenderer* r) { AddLight(r, 0.5, 0.7, 0.8)->SetPositional(true); },
      false },
    { "a fading light",
      [](vtkRenderer* r)
      {
        const auto light = AddLight(r, -0.6, 0.4, 0.9);
        light->SetPositional(true);
        light->SetAttenuationValues(0.4, 0.3, 0.5);
      },
      false },
    { "a spot light",
      [](vtkRenderer* r)
      {
        const auto light = AddLight(r, 0.3, 0.2, 1.4);
        light->SetPositional(true);
        light->SetConeAngle(20.0);
        light->SetExponent(6.0);
        light->SetIntensity(1.0);
      },
      false },
    { "a light at the camera",
      [](vtkRenderer* r)
      {
        const auto light = AddLight(r, 0.5, 0.5, 1.0);
        light->SetLightTypeToCameraLight();
        light->SetPositional(true);
      },
      false },
    { "nine lights", [](vtkRenderer* r) { AddMixedLights(r, 9); }, true },
    { "forty lights", [](vtkRenderer* r) { AddMixedLights(r, 40); }, false },
  };
  return arrangements;
}
}
