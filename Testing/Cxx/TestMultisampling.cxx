// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A window with 4 samples a pixel: right colours inside and outside of edges, a mixture on them,
// and opaque geometry hides sample by sample.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cstdio>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 40;
constexpr int Height = 30;

bool IsBetween(const glm::vec4& pixel, const glm::dvec4& a, const glm::dvec4& b)
{
  const double margin = 1.5 / 255.0;
  for (int channel = 0; channel < 4; ++channel)
  {
    if (pixel[channel] < std::min(a[channel], b[channel]) - margin ||
      pixel[channel] > std::max(a[channel], b[channel]) + margin)
    {
      return false;
    }
  }
  return true;
}
}

int TestMultisampling(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      if (!setup.HasStorage)
      {
        std::printf("not tested: %s: without storage buffers no method resolves samples\n",
          setup.Describe().c_str());
        return;
      }
      Rig rig(setup, Width, Height);
      rig.Window->SetMultiSamples(4);
      const glm::dvec4 background = rig.GetBackground();
      const Tolerance bound =
        ReferenceCompositor::RoundingBoundOfAnyStack(40, setup.FragmentStorage) +
        Rig::WindowTolerance();

      for (const int count : { 1, 5, 40 })
      {
        std::vector<Layer> layers = Random(count).Layers(count);
        if (count > 1)
        {
          layers[0].Depth = layers[1].Depth;
        }
        rig.RemoveProps();
        rig.AddStack(layers);
        report.Compare(std::to_string(count) + " layers", rig.RenderWindow(),
          Everywhere(ReferenceCompositor::Composite(layers, background)), bound);
      }
      auto* target = rig.GetGLWindow()->GetRenderFramebuffer();
      report.Check(target->GetMultiSamples() > 1,
        "the window has " + std::to_string(target->GetMultiSamples()) + " samples a pixel");

      // Edges between pixels: every pixel is known. Edges through the middle of a column: a
      // mixture there.
      const std::vector<Layer> layers{ { 0.25f, { 0.9f, 0.1f, 0.1f, 0.5f } },
        { 0.75f, { 0.1f, 0.9f, 0.1f, 0.75f } } };
      const Layer opaque{ 0.5f, { 0.9f, 0.9f, 0.2f, 1.0f } };
      for (const double edge : { 18.0, 18.5 })
      {
        const PixelRectangle left{ 0.0, 0.0, edge, Height };
        rig.RemoveProps();
        rig.AddQuad(opaque, left);
        rig.AddQuad(layers[0]);
        rig.AddQuad(layers[1]);
        const glm::dvec4 hidden =
          ReferenceCompositor::Composite({ layers[0] }, glm::dvec4(opaque.Color));
        const glm::dvec4 open = ReferenceCompositor::Composite(layers, background);
        const Image image = rig.RenderWindow();
        const std::string what = "opaque occluder up to " + std::to_string(edge);
        report.Compare(
          what, image,
          [&](int x, int y)
          {
            if (edge == 18.5 && x == 18)
            {
              // VTK's versions average samples in different colour spaces.
              const glm::vec4& pixel = image.At(x, y);
              return IsBetween(pixel, hidden, open) ? glm::dvec4(pixel) : hidden;
            }
            return x < edge ? hidden : open;
          },
          bound);
        if (edge == 18.5)
        {
          const glm::dvec4 pixel(image.At(18, 10));
          report.Check(std::abs(pixel.r - hidden.r) > 0.02 && std::abs(pixel.r - open.r) > 0.02,
            what + ": the edge is not smooth");
        }
      }

      // The silhouette of a translucent prop.
      rig.RemoveProps();
      rig.AddQuad(layers[1], { 10.5, 5.0, 30.0, 25.0 });
      const glm::dvec4 inside = ReferenceCompositor::Composite({ layers[1] }, background);
      const Image image = rig.RenderWindow();
      report.Compare(
        "translucent edge", image,
        [&](int x, int y)
        {
          if (x == 10 && y >= 5 && y < 25)
          {
            const glm::vec4& pixel = image.At(x, y);
            return IsBetween(pixel, inside, background) ? glm::dvec4(pixel) : inside;
          }
          return x > 10 && x < 30 && y >= 5 && y < 25 ? inside : background;
        },
        bound);
      const glm::dvec4 pixel(image.At(10, 10));
      report.Check(std::abs(pixel.g - inside.g) > 0.02 && std::abs(pixel.g - background.g) > 0.02,
        "the translucent edge is not smooth");
    });
}
