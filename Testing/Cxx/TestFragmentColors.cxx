// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress tests 15 to 19: opacities outside [0, 1], colours that are huge, tiny, negative, infinite
// or not a number. What half floats cannot hold is clamped as docs/vtkOITABufferPass.md says.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/FragmentColor.h"
#include "Scenes/Random.h"

#include <glm/common.hpp>

#include <cmath>
#include <limits>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 12;
constexpr int Height = 8;
const float NotANumber = std::numeric_limits<float>::quiet_NaN();
const float Infinity = std::numeric_limits<float>::infinity();

/// What a method keeps of the layers: opacities in [0, 1], half floats in [0, 65504]. Where dual
/// depth peeling has no framebuffer fetch it blends into floats, with colours as they are; so does
/// `auto` without storage, as it peels.
std::vector<Layer> Clamp(const std::vector<Layer>& layers, const Setup& setup)
{
  const bool keepsHalves = setup.Method == "dual" ? setup.HasFetch : setup.HasStorage;
  std::vector<Layer> kept;
  for (Layer layer : layers)
  {
    if (layer.Color.a > 0.0f) // not a number: leaves no trace
    {
      layer.Color.a = std::min(layer.Color.a, 1.0f);
      if (setup.FragmentStorage == Storage::Half && keepsHalves)
      {
        layer.Color = glm::clamp(layer.Color, 0.0f, 65504.0f);
      }
      kept.push_back(layer);
    }
  }
  return kept;
}

void CheckStack(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  const std::vector<Layer>& layers)
{
  const std::vector<Layer> kept = Clamp(layers, setup);
  rig.RemoveProps();
  AddStackOfAnyColor(rig, layers);
  report.Compare(what, rig.Render(),
    Everywhere(ReferenceCompositor::Composite(kept, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(kept, rig.GetBackground(), setup.FragmentStorage));
}

/// 15: opacities are clamped; one that is not a number leaves no trace.
void CheckOpacities(Report& report, Rig& rig, const Setup& setup)
{
  const float opacities[] = { -0.5f, -Infinity, 1.5f, 1000.0f, Infinity, NotANumber };
  for (const float opacity : opacities)
  {
    for (int position = 0; position < 3; ++position)
    {
      std::vector<Layer> layers = Random(15).Layers(3);
      layers[position].Color.a = opacity;
      CheckStack(report, rig, setup,
        "opacity " + std::to_string(opacity) + " at " + std::to_string(position), layers);
    }
  }
}

/// 16: with all colours and the background times s the picture is s times the picture.
void CheckScaling(Report& report, Rig& rig, const Setup& setup)
{
  const std::vector<Layer> layers = Random(16).Layers(7);
  const glm::dvec4 background = rig.GetBackground();
  const glm::dvec4 expected = ReferenceCompositor::Composite(layers, background);
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage);
  Image unscaled;
  for (int power = 0; power <= 6; ++power)
  {
    for (const int sign : { 1, -1 })
    {
      const float scale = std::pow(10.0f, float(sign * power));
      if (setup.FragmentStorage == Storage::Half && scale > 65504.0f)
      {
        continue; // clamped, see below
      }
      std::vector<Layer> scaled = layers;
      for (Layer& layer : scaled)
      {
        layer.Color = { scale * glm::vec3(layer.Color), layer.Color.a };
      }
      rig.SetBackground({ double(scale) * glm::dvec3(background), background.a });
      rig.RemoveProps();
      AddStackOfAnyColor(rig, scaled);
      Image image = rig.Render();
      for (glm::vec4& pixel : image.Pixels)
      {
        pixel = { glm::vec3(pixel) / scale, pixel.a };
      }
      unscaled = power == 0 ? image : unscaled;
      const std::string what = "times 1e" + std::to_string(sign * power);
      // Halves below 2^-14 have steps of 2^-24.
      const double half =
        setup.FragmentStorage == Storage::Half ? std::ldexp(1.0, -25) / scale : 0.0;
      report.Compare(what, image, Everywhere(expected), bound + Tolerance{ half, 0.0 });
      for (std::size_t i = 0; i < image.Pixels.size(); ++i)
      {
        if (image.Pixels[i].a != unscaled.Pixels[i].a)
        {
          report.Check(false, what + ": alpha depends on the colours");
          break;
        }
      }
    }
  }
  rig.SetBackground(background);
}

/// 17 and 18: colours larger than any half, and negative ones.
void CheckColors(Report& report, Rig& rig, const Setup& setup)
{
  for (const float size : { 65504.0f, 131008.0f, 1e30f, -0.5f, -40.0f, -65504.0f })
  {
    report.SetStressTest(size > 0.0f ? 17 : 18);
    std::vector<Layer> layers = Random(17).Layers(5);
    for (const int number : { 1, 3 })
    {
      layers[number].Color = { size, 0.25f * size, 0.5f, layers[number].Color.a };
    }
    CheckStack(report, rig, setup, "colours of " + std::to_string(size), layers);
    layers.push_back({ layers[1].Depth, { 0.75f * size, size, -size, 0.5f } });
    CheckStack(report, rig, setup, "coincident colours of " + std::to_string(size), layers);
  }
}

/// 19: one fragment with a colour that is no number or infinite spoils no other pixel, and its own
/// pixel is finite.
void CheckSpoiltFragment(Report& report, Rig& rig, const Setup&)
{
  const std::vector<Layer> layers = Random(19).Layers(6);
  rig.RemoveProps();
  AddStackOfAnyColor(rig, layers);
  const Image clean = rig.Render();
  for (const glm::vec3& color : { glm::vec3(NotANumber, 0.5f, 0.5f), glm::vec3(NotANumber),
         glm::vec3(Infinity), glm::vec3(-Infinity), glm::vec3(Infinity, NotANumber, -Infinity) })
  {
    const std::string what =
      "a fragment of " + std::to_string(color.r) + ", " + std::to_string(color.g);
    rig.RemoveProps();
    AddStackOfAnyColor(rig, layers);
    AddQuadOfAnyColor(rig, { 0.4f, glm::vec4(color, 0.5f) }, { 5.0, 3.0, 6.0, 4.0 });
    Image image = rig.Render();
    const glm::vec4 pixel = image.At(5, 3);
    report.Check(std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b) &&
        std::isfinite(pixel.a) && pixel.a > clean.At(5, 3).a,
      what + ": its pixel is " + std::to_string(pixel.r) + " " + std::to_string(pixel.g) + " " +
        std::to_string(pixel.b) + " " + std::to_string(pixel.a));
    image.Pixels[3 * Width + 5] = clean.At(5, 3);
    report.CompareBits(what + ", the other pixels", image, clean);
  }
}
}

int TestFragmentColors(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Width, Height);
      if (setup.IsContender) // an 8-bit window has no such colours; what opacities mean is our rule
      {
        return;
      }
      report.SetStressTest(15);
      CheckOpacities(report, rig, setup);
      report.SetStressTest(16);
      CheckScaling(report, rig, setup);
      CheckColors(report, rig, setup);
      report.SetStressTest(19);
      CheckSpoiltFragment(report, rig, setup);
    });
}
