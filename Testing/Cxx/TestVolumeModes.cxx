// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What volume mappers can do beside compositing samples of one component along parallel rays, with
// quads inside: other cameras, blend modes, parts of the volume that are left out, shaders of users.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"
#include "Scenes/VolumeSlab.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkMultiVolume.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPlane.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace vtkOITTest;

namespace
{
const std::vector<Layer> Quads{ { 0.1f, Red }, { 0.41f, Green }, { 0.55f, Blue }, { 0.9f, Red } };

/// What lies along the ray of a mode; and how far off the mode itself may be.
struct Mode
{
  std::string What;
  std::function<void(Rig&, vtkVolume*)> Change;
  std::vector<Layer> Expected; // empty: as without the change
  Tolerance Added;
};

std::vector<Mode> MakeModes()
{
  const Slab slab;
  const auto step = slab.GetSampleDistance();
  const Tolerance ofSample = { slab.Opacity * step, slab.Opacity * step };
  // The volume's colour with the opacity of its function, as a projection has it.
  const auto withLayer = [&](float depth)
  {
    std::vector<Layer> layers = Quads;
    layers.push_back({ depth, glm::vec4(slab.Color, slab.Opacity) });
    return layers;
  };
  const auto cut = [](float nearest, float farthest)
  {
    Slab part;
    part.Nearest = nearest;
    part.Farthest = farthest;
    part.Samples = 4000; // so that its end is its far face
    return PutBetween(Quads, { part });
  };
  return {
    { "as it is", [](Rig&, vtkVolume*) {}, {}, {} },
    { "jittering", [](Rig&, vtkVolume* v) { GetMapper(v)->UseJitteringOn(); }, {},
      ofSample + ofSample },
    { "image sample distance 3",
      [](Rig&, vtkVolume* v) { GetMapper(v)->SetImageSampleDistance(3.0f); }, {}, {} },
    { "maximum", [](Rig&, vtkVolume* v) { GetMapper(v)->SetBlendModeToMaximumIntensity(); },
      withLayer(slab.Nearest), {} },
    { "minimum", [](Rig&, vtkVolume* v) { GetMapper(v)->SetBlendModeToMinimumIntensity(); },
      withLayer(slab.Nearest), {} },
    { "slice",
      [](Rig& rig, vtkVolume* v)
      {
        vtkNew<vtkPlane> plane;
        const glm::dvec3 origin = rig.ToWorld(0, 0, 0.45);
        plane->SetOrigin(origin.x, origin.y, origin.z);
        plane->SetNormal(0.0, 0.0, 1.0);
        v->GetProperty()->SetSliceFunction(plane);
        GetMapper(v)->SetBlendModeToSlice();
      },
      withLayer(0.45f), {} },
    { "cropping",
      [](Rig& rig, vtkVolume* v)
      {
        GetMapper(v)->SetCroppingRegionPlanes(-3, 3, -3, 3, rig.ToWorld(0, 0, 0.6).z, 3);
        GetMapper(v)->SetCroppingRegionFlagsToSubVolume();
        GetMapper(v)->CroppingOn();
      },
      cut(0.3f, 0.6f), ofSample },
    { "clipping plane",
      [](Rig& rig, vtkVolume* v)
      {
        vtkNew<vtkPlane> plane;
        const glm::dvec3 origin = rig.ToWorld(0, 0, 0.5);
        plane->SetOrigin(origin.x, origin.y, origin.z);
        plane->SetNormal(0.0, 0.0, -1.0);
        GetMapper(v)->AddClippingPlane(plane);
      },
      cut(0.5f, 0.7f), ofSample },
    { "final colour window",
      [](Rig&, vtkVolume* v)
      {
        // Colours times 2, minus 0.3.
        GetMapper(v)->SetFinalColorWindow(0.5f);
        GetMapper(v)->SetFinalColorLevel(0.4f);
      },
      [&]
      {
        Slab bright = slab;
        bright.Color = 2.0f * slab.Color - glm::vec3(0.3f);
        return PutBetween(Quads, { bright });
      }(),
      {} },
    { "smart mapper",
      [](Rig&, vtkVolume* v)
      {
        vtkNew<vtkSmartVolumeMapper> mapper;
        mapper->SetInputData(GetMapper(v)->GetInput());
        mapper->SetRequestedRenderModeToGPU();
        mapper->AutoAdjustSampleDistancesOff();
        mapper->SetSampleDistance(GetMapper(v)->GetSampleDistance());
        v->SetMapper(mapper);
      },
      {}, {} },
  };
}

void CheckModes(Report& report, const Setup& setup)
{
  for (const Mode& mode : MakeModes())
  {
    Rig rig(setup, 20, 12);
    rig.AddStack(Quads);
    const Slab slab;
    vtkVolume* volume = AddSlab(rig, slab);
    mode.Change(rig, volume);
    const std::vector<Layer> all =
      mode.Expected.empty() ? PutBetween(Quads, { slab }) : mode.Expected;
    report.Compare(mode.What, rig.Render(),
      Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
        OfSamples + mode.Added);
    report.Check(rig.Pass->GetExact(), mode.What + ": not exact");
  }
}

/// Isosurfaces of a volume whose values grow along the view: a layer each.
void CheckIsosurfaces(Report& report, const Setup& setup)
{
  Rig rig(setup, 20, 12);
  rig.AddStack(Quads);
  Slab slab;
  slab.Samples = 400;
  vtkVolume* volume = AddSlab(rig, slab);
  auto* image = vtkImageData::SafeDownCast(GetMapper(volume)->GetInput());
  for (int z = 0; z < 8; ++z)
  {
    for (int y = 0; y < 8; ++y)
    {
      for (int x = 0; x < 8; ++x)
      {
        image->SetScalarComponentFromDouble(x, y, z, 0, 30 * z); // 210 at the near face
      }
    }
  }
  GetMapper(volume)->SetBlendModeToIsoSurface();
  volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 105.0);
  volume->GetProperty()->GetIsoSurfaceValues()->SetValue(1, 52.5);
  std::vector<Layer> all = Quads;
  all.push_back({ 0.5f, glm::vec4(slab.Color, slab.Opacity) });
  all.push_back({ 0.6f, glm::vec4(slab.Color, slab.Opacity) });
  const Tolerance ofOpacity = { 2.0 / 255.0, 2.0 / 255.0 };
  report.Compare("isosurfaces", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
      OfSamples + ofOpacity);
}

/// From a camera in perspective, the length of a ray grows with its slope.
void CheckPerspective(Report& report, const Setup& setup, double cameraDepth)
{
  Rig rig(setup, 20, 20);
  vtkCamera* camera = rig.Renderer->GetActiveCamera();
  const double place = DepthToZ(cameraDepth);
  camera->SetPosition(0.0, 0.0, place);
  camera->SetFocalPoint(0.0, 0.0, place - 1.0);
  camera->ParallelProjectionOff();
  camera->SetViewAngle(20.0);
  camera->SetClippingRange(0.05, 6.0);
  Slab slab;
  slab.Samples = 400;
  const std::vector<Layer> quads{ { 0.41f, Green }, { 0.55f, Blue }, { 0.65f, Red } };
  rig.AddStack(quads);
  AddSlab(rig, slab);
  const glm::dvec4 background = rig.GetBackground();
  const double nearest = std::max(double(slab.Nearest), cameraDepth + 0.025);
  const double step = slab.GetSampleDistance();
  const auto expected = [&](int x, int y)
  {
    const double scale = std::tan(glm::radians(10.0)) / 10.0;
    const double slope = std::hypot((x + 0.5 - 10) * scale, (y + 0.5 - 10) * scale);
    Slab part = slab;
    part.Nearest = static_cast<float>(nearest);
    part.Samples = 100000;
    part.Opacity =
      static_cast<float>(1.0 - std::pow(1.0 - slab.Opacity, std::sqrt(1.0 + slope * slope)));
    return ReferenceCompositor::Composite(PutBetween(quads, { part }), background);
  };
  report.Compare("perspective", rig.Render(), expected,
    ReferenceCompositor::RoundingBoundOfAnyStack(3, setup.FragmentStorage) + OfSamples +
      Tolerance{ 2 * slab.Opacity * step, 2 * slab.Opacity * step });
  report.Check(rig.Pass->GetExact(), "perspective: not exact");
}

/// Several inputs of one mapper need no order among each other.
void CheckMultiVolume(Report& report, const Setup& setup)
{
  Rig rig(setup, 20, 12);
  rig.AddStack(Quads);
  Slab left;
  left.X0 = -2.0f;
  left.X1 = 0.0f;
  Slab right = left;
  right.X0 = 0.0f;
  right.X1 = 2.0f;
  const vtkSmartPointer<vtkVolume> first = MakeSlab(left);
  const vtkSmartPointer<vtkVolume> second = MakeSlab(right);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputDataObject(0, GetMapper(first)->GetInput());
  mapper->SetInputDataObject(1, GetMapper(second)->GetInput());
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(left.GetSampleDistance()));
  vtkNew<vtkMultiVolume> volume;
  volume->SetMapper(mapper);
  volume->SetVolume(first, 0);
  volume->SetVolume(second, 1);
  AddVolume(rig, volume);
  const std::vector<Layer> all = PutBetween(Quads, { Slab() });
  const double step = left.GetSampleDistance();
  report.Compare("two volumes of one mapper", Crop(rig.Render(), 2, 0, 6, 12),
    Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
      OfSamples + Tolerance{ left.Opacity * step, left.Opacity * step });
  report.Check(rig.Pass->GetExact(), "two volumes of one mapper: not exact");
}

/// A shader that replaces what March begins with is drawn over, with a line.
void CheckUserShader(Report& report, const Setup& setup)
{
  const LineCatcher lines;
  Rig rig(setup, 20, 12);
  rig.AddStack(Quads);
  vtkVolume* volume = AddSlab(rig, {});
  volume->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::CallWorker::Impl", true,
    "initializeRayCast(); castRay(-1.0, -1.0); finalizeRayCast();\n", true);
  rig.Render();
  report.Check(!rig.Pass->GetExact(), "a shader of the user's: called exact");
  report.Check(lines.GetTexts().size() == 1, "a shader of the user's: " + lines.Describe());
}
}

int TestVolumeModes(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      if (!setup.HasStorage || setup.FragmentStorage != Storage::Half)
      {
        return; // see TestVolumeSlabs
      }
      CheckModes(report, setup);
      CheckIsosurfaces(report, setup);
      CheckPerspective(report, setup, -1.0);
      CheckPerspective(report, setup, 0.35);
      CheckMultiVolume(report, setup);
      CheckUserShader(report, setup);
    });
}
