// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Layers that are lit after they were sorted look as those that VTK's mappers have lit: within a step of
// 8 bits of the A-buffer, for all kinds of lights and materials, also those that cannot be lit later.
// Adding, moving and removing lights makes no program.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/GLObjects.h"
#include "Rig/Rig.h"
#include "Scenes/LightArrangements.h"
#include "Scenes/LitScenes.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 72;
constexpr int Height = 56;
constexpr Tolerance OneStep{ 1.0 / 255.0, 1.0 / 255.0 };

/// The picture of a scene by a method.
Image Draw(const Setup& setup, const std::string& method, const LitMaterial& material,
  const LightArrangement& lights, std::string& algorithm)
{
  Setup other = setup;
  other.Method = method;
  Rig rig(other, Width, Height);
  rig.SetBackground({ 0.2, 0.4, 0.6, 1.0 });
  AddLitScene(rig.Renderer, material);
  lights.Add(rig.Renderer);
  Image image = rig.Render();
  algorithm = rig.Pass->GetAlgorithmName();
  return image;
}

void CompareWithForward(
  Report& report, const Setup& setup, const LitMaterial& material, const LightArrangement& lights)
{
  std::string algorithm;
  const Image forward = Draw(setup, "abuffer", material, lights, algorithm);
  const Image deferred = Draw(setup, setup.Method, material, lights, algorithm);
  const std::string what = std::string(material.Name) + " under " + lights.Name;
  report.Compare(what, deferred, forward, OneStep);
  // What keeps float colours is lit by the mappers.
  const bool isHalf = setup.FragmentStorage == Storage::Half;
  const std::string expected = setup.Method == "deferred" ? "deferred depth peeling"
    : isHalf                                              ? "deferred A-buffer"
                                                          : "A-buffer";
  report.Check(algorithm == expected, what + " was drawn by the " + algorithm);
}

/// Whether the lights of an arrangement are seen at all.
void CheckThatLightsMatter(Report& report, const Setup& setup)
{
  std::string algorithm;
  const LitMaterial& material = GetLitMaterials().front();
  const Image first =
    Draw(setup, setup.Method, material, GetLightArrangements().front(), algorithm);
  for (const LightArrangement& lights : GetLightArrangements())
  {
    if (&lights != &GetLightArrangements().front())
    {
      const Image image = Draw(setup, setup.Method, material, lights, algorithm);
      double largest = 0.0;
      for (int y = 0; y < Height; ++y)
      {
        for (int x = 0; x < Width; ++x)
        {
          const glm::dvec4 d = glm::abs(image.At(x, y) - first.At(x, y));
          largest = std::max({ largest, d.r, d.g, d.b });
        }
      }
      report.Check(largest > 4.0 / 255.0, std::string(lights.Name) + " look as the headlight does");
    }
  }
}

/// Programs of the context, while lights come, move and go.
void CheckThatLightsCompileNothing(Report& report, const Setup& setup, const LitMaterial& material)
{
  Rig rig(setup, Width, Height);
  AddLitScene(rig.Renderer, material);
  vtkNew<vtkLight> key;
  key->SetPosition(1.0, 2.0, 3.0);
  rig.Renderer->AddLight(key);
  const auto countPrograms = [&]
  {
    rig.Window->Render();
    rig.Window->MakeCurrent();
    return GLObjectCounts::OfCurrentContext().Programs;
  };
  countPrograms();
  const int before = countPrograms();
  vtkNew<vtkLight> spot;
  spot->SetPositional(true);
  spot->SetConeAngle(30.0);
  spot->SetPosition(0.0, 1.0, 3.0);
  rig.Renderer->AddLight(spot);
  report.Check(countPrograms() == before, "a light that was added made a program");
  spot->SetPosition(1.0, 0.0, 3.0);
  spot->SetColor(1.0, 0.5, 0.2);
  spot->SetAttenuationValues(1.0, 0.5, 0.1);
  report.Check(countPrograms() == before, "a light that was changed made a program");
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkLight> more;
    more->SetPosition(i, 1.0, 3.0);
    more->SetPositional(i % 2 == 0);
    rig.Renderer->AddLight(more);
  }
  report.Check(countPrograms() == before, "twenty lights that were added made a program");
  rig.Renderer->RemoveLight(spot);
  report.Check(countPrograms() == before, "a light that was removed made a program");
}

/// Lists whose fragments cannot all be lit in one draw of a shader are lit by several, or by the mappers.
void CheckLongLists(Report& report, const Setup& setup)
{
  constexpr int Layers = 700;
  constexpr int Lights = 100;
  Rig rig(setup, 16, 12);
  std::vector<Layer> layers;
  std::vector<float> depths;
  for (int i = 0; i < Layers; ++i)
  {
    depths.push_back(0.1f + 0.001f * i);
    layers.push_back({ depths.back(), { 0.25f, 0.5f, 0.75f, 0.0078125f } });
  }
  rig.AddEqualLayers(depths, layers.front().Color);
  for (int i = 0; i < Lights; ++i)
  {
    rig.Renderer->AddLight(vtkNew<vtkLight>());
  }
  for (int frame = 0; frame < 2; ++frame)
  {
    report.Compare("long lists under many lights", rig.Render(),
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
    report.Check(rig.Pass->GetAlgorithmName() ==
        (setup.FragmentStorage == Storage::Half ? "deferred A-buffer" : "A-buffer"),
      "long lists were drawn by the " + rig.Pass->GetAlgorithmName());
  }
}

/// Coincident fragments of one normal are exact by either way, those of two are not when peeled.
void CheckCoincidentNormals(Report& report, const Setup& setup)
{
  for (const bool differ : { false, true })
  {
    Rig rig(setup, Width, Height);
    for (const double tilt : { 0.0, differ ? 0.6 : 0.0 })
    {
      vtkActor* actor = rig.AddQuad({ 0.5f, { 0.8f, 0.4f, 0.6f, 0.5f } });
      actor->GetProperty()->LightingOn();
      vtkNew<vtkFloatArray> normals;
      normals->SetNumberOfComponents(3);
      for (int i = 0; i < 4; ++i)
      {
        normals->InsertNextTuple3(tilt, 0.0, std::sqrt(1.0 - tilt * tilt));
      }
      vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))
        ->GetPointData()
        ->SetNormals(normals);
    }
    rig.Render();
    const bool isExact = setup.Method != "deferred" || !differ;
    report.Check(rig.Pass->GetExact() == isExact,
      std::string("coincident layers of ") + (differ ? "two normals" : "one normal") +
        (isExact ? " are not exact" : " are called exact"));
  }
}

/// The automatic choice takes it where there are many lights, and until there are few.
void CheckChoice(Report& report, const Setup& setup)
{
  Setup automatic = setup;
  automatic.Method = "auto";
  Rig rig(automatic, Width, Height);
  AddLitScene(rig.Renderer, GetLitMaterials().front());
  const bool canDefer = setup.FragmentStorage == Storage::Half && setup.HasStorage;
  for (const auto& [lights, defers] : { std::pair(1, false), std::pair(4, false),
         std::pair(5, true), std::pair(3, true), std::pair(2, false), std::pair(4, false) })
  {
    rig.Renderer->RemoveAllLights();
    for (int i = 0; i < lights; ++i)
    {
      vtkNew<vtkLight> light;
      light->SetPosition(i, 1.0, 3.0);
      rig.Renderer->AddLight(light);
    }
    rig.Render();
    const bool isDeferred = rig.Pass->GetAlgorithmName() == "deferred A-buffer";
    report.Check(isDeferred == (defers && canDefer),
      "auto with " + std::to_string(lights) + " lights: " + rig.Pass->GetAlgorithmName());
  }
}
}

int TestDeferredLights(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig::KeepWindow(true); // and its shaders
      const bool isFirst = setup.Tier == "all extensions";
      for (const LightArrangement& lights : GetLightArrangements())
      {
        if (isFirst || lights.IsForEachMaterial)
        {
          CompareWithForward(report, setup, GetLitMaterials().front(), lights);
        }
      }
      for (const LitMaterial& material : GetLitMaterials())
      {
        for (const LightArrangement& lights : GetLightArrangements())
        {
          if (isFirst && lights.IsForEachMaterial)
          {
            CompareWithForward(report, setup, material, lights);
          }
        }
      }
      if (isFirst)
      {
        CheckThatLightsMatter(report, setup);
      }
      Rig::KeepWindow(false);
      if (setup.Method == "deferred" || setup.FragmentStorage == Storage::Half)
      {
        // Otherwise the mappers light.
        for (const LitMaterial& material : GetLitMaterials())
        {
          const bool isPhysical = setup.Method == "deferred-abuffer" && isFirst &&
            (std::strcmp(material.Name, "physically based") == 0 ||
              std::strcmp(material.Name, "physically based with textures") == 0);
          if (&material == &GetLitMaterials().front() || isPhysical)
          {
            CheckThatLightsCompileNothing(report, setup, material);
          }
        }
      }
      CheckCoincidentNormals(report, setup);
      if (setup.Method == "deferred-abuffer")
      {
        CheckLongLists(report, setup);
      }
      CheckChoice(report, setup);
    });
}
