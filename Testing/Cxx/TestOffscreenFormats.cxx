// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Framebuffers of other formats: colours as floats, with values above 1, and depths of 24 and 32
// bits. Opaque geometry in the same plane is never mistaken for being in front.

#include "Oracle/ReferenceCompositor.h"
#include "Oracle/SingleLayer.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkFramebufferPass.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <cstdio>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 48;
constexpr int Height = 32;

struct Format
{
  const char* Name;
  int ColorType;
  int DepthFormat;
};

const Format Formats[] = {
  { "RGBA32F, D32F", VTK_FLOAT, vtkTextureObject::Float32 },
  { "RGBA32F, D24", VTK_FLOAT, vtkTextureObject::Fixed24 },
  { "RGBA32F, D32", VTK_FLOAT, vtkTextureObject::Fixed32 },
  { "RGBA8, D24", VTK_UNSIGNED_CHAR, vtkTextureObject::Fixed24 },
  { "RGBA8, D32F", VTK_UNSIGNED_CHAR, vtkTextureObject::Float32 },
};

void CheckFormat(Report& report, const Setup& setup, const Format& format)
{
  const std::string name = format.Name;
  Rig rig(setup, Width, Height);
  rig.SetTargetFormat(format.ColorType, format.DepthFormat);
  const bool isFloat = format.ColorType == VTK_FLOAT;
  const Tolerance rounding = isFloat ? Tolerance() : Rig::WindowTolerance();

  const std::vector<Layer> layers = Random(41).Layers(9);
  rig.AddStack(layers);
  report.Compare(name + ": random layers", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage) +
      rounding);
  if (!isFloat)
  {
    return;
  }

  // Coplanar with an opaque face, where rounding depths to 24 bits would make it speckle.
  const glm::vec4 orange(0.9f, 0.5f, 0.1f, 0.375f);
  // With polygon offsets on, VTK writes gl_FragDepth, so that the pass has to test the depth
  // itself.
  for (const bool writesDepth : { false, true })
  {
    const bool usesABuffer =
      setup.Method == "abuffer" || setup.Method == "auto" || setup.Method == "deferred-abuffer";
    const bool stores =
      usesABuffer ? setup.HasStorage : setup.Method == "multilayer" && setup.HasInterlock;
    if (writesDepth && stores && !setup.HasFetch)
    {
      // What is stored is not undone by a late test, so shaders compare with a copy of the depth
      // buffer then: docs/vtkOITABufferPass.md, docs/vtkOITMultiLayerPeelingPass.md.
      std::printf("not tested: %s: coplanar with offsets\n", setup.Describe().c_str());
      continue;
    }
    if (writesDepth)
    {
      vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    }
    for (const double slope : { 0.03, 0.4, 0.61 })
    {
      rig.RemoveProps();
      vtkActor* actors[2];
      for (int i = 0; i < 2; ++i)
      {
        actors[i] = rig.AddRamp(
          0.5 - slope, 0.5 + 0.7 * slope, i ? orange : glm::vec4(0.1f, 0.3f, 0.9f, 1.0f));
        actors[i]->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 3.0);
      }
      CheckSingleLayer(report, rig, setup,
        name + (writesDepth ? ": coplanar with offsets" : ": coplanar") + ", slope " +
          std::to_string(slope),
        actors[1], orange.a, 1000, 0);
    }
    vtkMapper::SetResolveCoincidentTopologyToDefault();
  }

  // High dynamic range: everything scales.
  std::vector<Layer> bright = layers;
  for (Layer& layer : bright)
  {
    layer.Color = { 20.0f * layer.Color.r, 20.0f * layer.Color.g, 20.0f * layer.Color.b,
      layer.Color.a };
  }
  rig.RemoveProps();
  rig.AddStack(bright);
  report.Compare(name + ": bright layers", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(bright, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(bright, rig.GetBackground(), setup.FragmentStorage));
}

/// VTK's own framebuffer pass around ours, with half-float and float colours.
void CheckFramebufferPass(Report& report, const Setup& setup)
{
  for (const int format : { vtkTextureObject::Float16, vtkTextureObject::Float32 })
  {
    Rig rig(setup, Width, Height);
    vtkSmartPointer<vtkRenderPass> inner = rig.Renderer->GetPass();
    vtkNew<vtkFramebufferPass> outer;
    outer->SetDelegatePass(inner);
    outer->SetColorFormat(format);
    outer->SetDepthFormat(vtkTextureObject::Float32);
    rig.Renderer->SetPass(outer);
    const std::vector<Layer> layers = Random(43).Layers(9);
    rig.AddStack(layers);
    const bool isHalf = format == vtkTextureObject::Float16;
    report.Compare(std::string("vtkFramebufferPass, ") + (isHalf ? "RGBA16F" : "RGBA32F"),
      rig.Render(), Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage) +
        // The background and the result are rounded to a half; the blend unit may truncate.
        (isHalf ? Tolerance{ 2.0 / 1024, 2.0 / 1024 } : Tolerance()));
    rig.Renderer->SetPass(inner);
    outer->ReleaseGraphicsResources(rig.Window);
  }
}
}

int TestOffscreenFormats(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      if (setup.IsContender) // draws into the window
      {
        return;
      }
      report.SetStressTest(10);
      for (const Format& format : Formats)
      {
        CheckFormat(report, setup, format);
      }
      if (setup.UseMode != Use::Installed) // needs a pass to put around
      {
        CheckFramebufferPass(report, setup);
      }
    });
}
