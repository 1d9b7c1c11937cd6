// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What a peeling pass says about a frame: geometry passes as its documentation promises, fragments,
// depth complexity, and a bound for what was cut off that holds.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkOITBucketPeelingPass.h"
#include "vtkOITMultiLayerPeelingPass.h"
#include "vtkOITPeelingPass.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 24;
constexpr int Height = 16;

/// The largest number of geometry passes for N layers without collisions or coincident fragments.
int GetLargestNumberOfPasses(const Setup& setup, vtkOITPass* pass, int layers)
{
  if (setup.Method == "peel" || setup.Method == "deferred")
  {
    return layers + 1;
  }
  if (setup.Method == "dual")
  {
    if (setup.HasFetch) // 3 layers from each side, with float colours 1
    {
      const int k = setup.FragmentStorage == Storage::Half ? 6 : 2;
      return (layers + k - 1) / k;
    }
    return layers / 2 + 2;
  }
  if (auto* multiLayer = vtkOITMultiLayerPeelingPass::SafeDownCast(pass))
  {
    const int k = multiLayer->GetNumberOfLayersPerPass();
    const int ordered = (layers + k - 1) / k;
    return setup.HasFetch ? ordered : ordered * (k + 2) + 1;
  }
  return 1 + (layers + 1) / 2; // buckets: the nearest and the farthest, whatever lies between
}

void CheckCounts(Report& report, Rig& rig, const Setup& setup, int layers)
{
  const std::string what = std::to_string(layers) + " layers";
  const std::vector<Layer> stack = Random(50 + layers).Layers(layers);
  rig.RemoveProps();
  rig.AddStack(stack);
  // A pass waits for no query before it has peeled as often as in the last frame, so the first
  // frame of a scene with fewer layers may cost what the last scene did.
  const int before = rig.Pass->GetNumberOfGeometryPasses();
  for (int frame = 0; frame < 3; ++frame)
  {
    // Also where the method changes with the depth complexity of the frames before.
    report.Compare(what + ", frame " + std::to_string(frame), rig.Render(),
      Everywhere(ReferenceCompositor::Composite(stack, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(stack, rig.GetBackground(), setup.FragmentStorage));
    const int passes = rig.Pass->GetNumberOfGeometryPasses();
    const int needed = GetLargestNumberOfPasses(setup, rig.Pass, layers);
    // Dual peeling chooses by the frame before, too, how many layers it peels at once.
    const int first = setup.Method == "dual" ? std::max(needed, (layers + 1) / 2) : needed;
    const int largest = frame == 0 ? std::max(first, before) : needed;
    const bool isFixed = frame > 0 &&
      (setup.Method == "peel" ||
        ((setup.Method == "multilayer" || setup.Method == "dual") && setup.HasFetch));
    report.Check(isFixed ? passes == largest : passes <= largest,
      what + ", frame " + std::to_string(frame) + ": " + std::to_string(passes) +
        " geometry passes, expected " + std::to_string(largest));
    report.Check(rig.Pass->GetNumberOfFragments() == vtkTypeInt64(layers) * Width * Height,
      what + ": fragments " + std::to_string(rig.Pass->GetNumberOfFragments()));
    report.Check(rig.Pass->GetMaximumDepthComplexity() == layers,
      what + ": depth complexity " + std::to_string(rig.Pass->GetMaximumDepthComplexity()));
    report.Check(rig.Pass->GetExact() && rig.Pass->GetErrorBound() == 0.0, what + ": not exact");
  }
}

/// Within the bound that the pass states, and the bound is not an empty one.
void CheckBound(Report& report, Rig& rig, const Setup& setup, const std::vector<Layer>& layers,
  const std::string& what, double largestBound)
{
  rig.RemoveProps();
  rig.AddStack(layers);
  rig.Render(); // may peel as often as the scene before
  const Image image = rig.Render();
  const double bound = rig.Pass->GetErrorBound();
  report.Check(!rig.Pass->GetExact() && bound > 0.0 && bound <= largestBound,
    what + ": the error bound is " + std::to_string(bound));
  report.Compare(what, image,
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage) +
      Tolerance{ bound, bound });
}

void CheckLimits(Report& report, Rig& rig, const Setup& setup)
{
  auto* pass = vtkOITPeelingPass::SafeDownCast(rig.Pass);
  const std::vector<Layer> layers = EqualLayers(Random(5).Depths(40), { 0.9f, 0.2f, 0.1f, 0.1f });
  std::vector<Layer> colors = layers;
  Random random(6);
  for (Layer& layer : colors)
  {
    layer.Color = glm::vec4(random.Uniform(), random.Uniform(), random.Uniform(), 0.1);
  }

  pass->SetMaximumNumberOfPeels(2);
  CheckBound(report, rig, setup, colors, "two peels", 1.0);
  pass->SetUseOcclusionQuery(false);
  CheckBound(report, rig, setup, colors, "two peels without queries", 1.0);
  const int passes = pass->GetNumberOfGeometryPasses();
  rig.RemoveProps();
  rig.AddStack({ layers[0] });
  rig.Render();
  report.Check(pass->GetNumberOfGeometryPasses() == passes || setup.Method == "multilayer",
    "without queries the number of geometry passes depends on the scene");
  pass->SetUseOcclusionQuery(true);
  pass->SetMaximumNumberOfPeels(0);

  // Layers behind 9 of opacity 1/2 are skipped: T = 1/512.
  std::vector<Layer> dark = EqualLayers(Random(7).Depths(14), { 0.0f, 0.0f, 0.0f, 0.5f });
  std::sort(
    dark.begin(), dark.end(), [](const Layer& a, const Layer& b) { return a.Depth < b.Depth; });
  for (int i = 9; i < 14; ++i)
  {
    dark[i].Color = { 1.0f, 1.0f, 1.0f, 0.5f };
  }
  if (setup.Method == "peel") // others may have peeled some of them already
  {
    pass->SetTransmittanceThreshold(1.0 / 512);
    CheckBound(report, rig, setup, dark, "black in front of white", 1.0 / 512 + 1e-6);
    report.Check(pass->GetNumberOfGeometryPasses() == 10,
      "black in front of white: " + std::to_string(pass->GetNumberOfGeometryPasses()) + " passes");
    pass->SetTransmittanceThreshold(0.0);
  }

  pass->SetOcclusionRatio(0.5);
  rig.RemoveProps();
  rig.AddStack({ layers[0], layers[1] });
  for (const Layer& layer : colors)
  {
    rig.AddQuad(layer, { 0.0, 0.0, 8.0, 8.0 }); // a sixth of the pixels
  }
  rig.Render();
  report.Check(!pass->GetExact() && pass->GetErrorBound() > 0.0 && pass->GetErrorBound() <= 1.0,
    "occlusion ratio: nothing was cut off");
  pass->SetOcclusionRatio(0.0);
}

/// Frames that differ from the ones before in depth complexity and precision, in one band and in
/// several: what a pass keeps from frame to frame must not show.
void CheckChanges(Report& report, const Setup& setup, vtkTypeInt64 limit)
{
  // Buckets keep so much for each pixel that a small window has bands.
  const bool hasBuckets = setup.Method.rfind("bucket", 0) == 0;
  Rig rig(setup, hasBuckets ? 64 : 160, hasBuckets ? 48 : 120);
  rig.Pass->SetMaximumBufferSize(limit);
  int frame = 0;
  for (const int layers : { 1, 1, 8, 8, 1, 1, 1, 1, 20, 2, 7 })
  {
    const bool isFloat = frame % 3 == 2 && setup.Method != "multilayer"; // which keeps half floats
    const Storage storage = isFloat ? Storage::Float32 : setup.FragmentStorage;
    rig.Pass->SetFragmentPrecision(storage == Storage::Half ? vtkOITPass::HALF : vtkOITPass::FLOAT);
    const std::vector<Layer> stack = Random(80 + layers).Layers(layers);
    rig.RemoveProps();
    rig.AddStack(stack);
    const std::string what = "change " + std::to_string(frame++) + " to " + std::to_string(layers) +
      " layers, limit " + std::to_string(limit);
    report.Compare(what, rig.Render(),
      Everywhere(ReferenceCompositor::Composite(stack, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(stack, rig.GetBackground(), setup.FragmentStorage));
    report.Check(rig.Pass->GetMaximumDepthComplexity() == layers,
      what + ": depth complexity " + std::to_string(rig.Pass->GetMaximumDepthComplexity()));
    report.Check(limit == 0 || rig.Pass->GetBufferSizeInBytes() <= limit,
      what + ": " + std::to_string(rig.Pass->GetBufferSizeInBytes()) + " bytes");
  }
}

void CheckLayersPerPass(Report& report, Rig& rig, const Setup& setup)
{
  auto* pass = vtkOITMultiLayerPeelingPass::SafeDownCast(rig.Pass);
  if (!pass)
  {
    return;
  }
  pass->SetNumberOfLayersPerPass(4);
  for (const int layers : { 1, 4, 5, 13 })
  {
    CheckCounts(report, rig, setup, layers);
  }
  if (setup.HasFetch)
  {
    pass->SetNumberOfLayersPerPass(16);
    for (const int layers : { 16, 17, 40 })
    {
      const std::vector<Layer> stack = Random(layers).Layers(layers);
      CheckBound(report, rig, setup, stack, "16 a pass, " + std::to_string(layers), 0.1);
      report.Check(pass->GetNumberOfGeometryPasses() == (layers + 15) / 16, "16 a pass: passes");
    }
    pass->SetSynchronization(vtkOITMultiLayerPeelingPass::TEXTURE_BARRIER);
    pass->SetNumberOfLayersPerPass(8);
    const std::vector<Layer> stack = Random(3).Layers(20);
    rig.RemoveProps();
    rig.AddStack(stack);
    report.Compare("the paper's scheme", rig.Render(),
      Everywhere(ReferenceCompositor::Composite(stack, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(stack, rig.GetBackground(), setup.FragmentStorage));
    pass->SetSynchronization(vtkOITMultiLayerPeelingPass::AUTOMATIC);
  }
  pass->SetNumberOfLayersPerPass(8);
}

/// Moves an actor away after each draw of its mapper.
class MovingAway : public vtkCommand
{
public:
  static MovingAway* New() { return new MovingAway; }
  void Execute(vtkObject*, unsigned long, void*) override { this->Actor->AddPosition(0, 0, -0.01); }

  vtkActor* Actor = nullptr;
};

/// Fragments that are not where they were in the pass before cannot be peeled: buckets count them.
void CheckMovingFragments(Report& report, Rig& rig)
{
  auto* pass = vtkOITBucketPeelingPass::SafeDownCast(rig.Pass);
  if (!pass)
  {
    return;
  }
  rig.RemoveProps();
  rig.AddStack({ { 0.5f, { 0.9f, 0.2f, 0.1f, 0.25f } } });
  vtkActor* actor = rig.Renderer->GetActors()->GetLastActor();
  rig.Render();
  report.Check(pass->GetExact() && pass->GetNumberOfLostFragments() == 0, "a prop at rest");
  vtkNew<MovingAway> moving;
  moving->Actor = actor;
  actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, moving);
  rig.Render();
  report.Check(!pass->GetExact() && pass->GetNumberOfLostFragments() == Width * Height,
    "a prop that moves: " + std::to_string(pass->GetNumberOfLostFragments()) + " lost");
}

/// A single shot, whose picture may be off by so much; of the fragments of a pixel some are not kept.
void CheckShot(Report& report, Rig& rig, const std::string& what, const std::vector<Layer>& layers,
  int lost, bool isExact, double allowed)
{
  auto* pass = vtkOITBucketPeelingPass::SafeDownCast(rig.Pass);
  rig.RemoveProps();
  rig.AddStack(layers);
  report.Compare("single shot, " + what, rig.Render(),
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())), { allowed, allowed });
  report.Check(pass->GetExact() == isExact && (pass->GetErrorBound() == 0.0) == isExact,
    what + ": exact " + std::to_string(pass->GetExact()) + ", bound " +
      std::to_string(pass->GetErrorBound()));
  report.Check(pass->GetNumberOfLostFragments() == vtkTypeInt64(lost) * Width * Height &&
      pass->GetMaximumDepthComplexity() == int(layers.size()),
    what + ": " + std::to_string(pass->GetNumberOfLostFragments()) + " lost of " +
      std::to_string(pass->GetNumberOfFragments()));
}

/// The paper's single shot: of fragments that share a bucket, one or two are kept; of the others the
/// sums are. Adaptive buckets have room for each.
void CheckSingleShot(Report& report, Rig& rig, const Setup& setup)
{
  auto* pass = vtkOITBucketPeelingPass::SafeDownCast(rig.Pass);
  if (!pass)
  {
    return;
  }
  const bool isAdaptive = setup.Method == "bucket-adaptive";
  const bool isPairs = setup.Method == "bucket-pairs";
  // Colours of 8 bits; the opacities follow from the sum where they are equal, and it has float32.
  const double allowed = isAdaptive ? 2e-6 : 0.0025;
  pass->SetMaximumNumberOfPeels(1);
  for (const int range : { vtkOITBucketPeelingPass::BOUNDS, vtkOITBucketPeelingPass::EXACT })
  {
    pass->SetDepthRange(range);
    const glm::vec4 color(0.9f, 0.2f, 0.1f, 0.3f);
    CheckShot(report, rig, "one fragment a bucket",
      EqualLayers({ 0.1f, 0.3f, 0.5f, 0.7f, 0.9f }, color), 0, isAdaptive, allowed);
    const int geometryPasses =
      (range == vtkOITBucketPeelingPass::EXACT ? 1 : 0) + (isAdaptive ? 2 : 1);
    report.Check(pass->GetNumberOfGeometryPasses() == geometryPasses,
      "single shot: " + std::to_string(pass->GetNumberOfGeometryPasses()) + " geometry passes");

    // Up to three that are not kept are found, with their buckets.
    const float close = std::ldexp(1.0f, -18);
    CheckShot(report, rig, "four close together",
      EqualLayers({ 0.1f, 0.5f, 0.5f + close, 0.5f + 2 * close, 0.5f + 3 * close, 0.9f }, color),
      isAdaptive ? 0 : 3, isAdaptive && setup.FragmentStorage == Storage::Half,
      isAdaptive ? 3e-5 : allowed);
    // One that is not kept gets its own colour back, behind the one that is.
    const std::vector<Layer> twins{ { 0.1f, { 0.2f, 0.9f, 0.5f, 0.3f } },
      { 0.5f, { 1.0f, 0.6f, 0.2f, 0.3f } }, { 0.52f, { 0.2f, 0.4f, 0.6f, 0.3f } },
      { 0.9f, { 0.0f, 0.2f, 1.0f, 0.3f } } };
    CheckShot(report, rig, "two in a bucket", twins, isAdaptive || isPairs ? 0 : 1, isAdaptive,
      isAdaptive ? allowed : 0.006);
    // Opacities of props have numbers.
    CheckShot(report, rig, "two opacities",
      { { 0.2f, { 0.2f, 0.9f, 0.5f, 0.3f } }, { 0.5f, { 1.0f, 0.6f, 0.2f, 0.6f } },
        { 0.8f, { 0.0f, 0.2f, 1.0f, 0.3f } } },
      0, isAdaptive, allowed);
    // Coincident ones share a slot.
    CheckShot(report, rig, "three of one depth",
      EqualLayers({ 0.1f, 0.5f, 0.5f, 0.5f, 0.9f }, color), 2, false, 0.0025);
    // With up to 8 layers floats are kept, with up to 16 colours of 15 bits, with more those of 8.
    for (const int layers : { 1, 8, 12, 16, 20, 32 })
    {
      std::vector<float> depths(layers);
      for (int i = 0; i < layers; ++i)
      {
        depths[i] = 0.1f + 0.8f * (float(i) + 0.3f * std::sin(float(i))) / float(layers);
      }
      const bool isKept = isAdaptive && layers <= 16;
      const bool isExact = isKept && (layers <= 8 || setup.FragmentStorage == Storage::Half);
      const std::vector<Layer> stack = EqualLayers(depths, { 0.9f, 0.2f, 0.1f, 0.1f });
      rig.RemoveProps();
      rig.AddStack(stack);
      report.Compare("single shot, " + std::to_string(layers) + " layers", rig.Render(),
        Everywhere(ReferenceCompositor::Composite(stack, rig.GetBackground())),
        isKept ? Tolerance{ 3e-4, 3e-4 } : Tolerance{ 0.004, 0.004 });
      report.Check(pass->GetExact() == isExact && (pass->GetErrorBound() < 0.01) == isKept &&
          (!isAdaptive || pass->GetNumberOfLostFragments() == 0),
        "single shot, " + std::to_string(layers) +
          " layers: " + std::to_string(pass->GetNumberOfLostFragments()) + " lost");
    }
  }
  pass->SetMaximumNumberOfPeels(0);
  const std::vector<Layer> one{ { 0.5f, { 0.9f, 0.2f, 0.1f, 0.25f } } }; // zmin = zmax
  rig.RemoveProps();
  rig.AddStack(one);
  report.Compare("one layer, exact range", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(one, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(one, rig.GetBackground(), setup.FragmentStorage));
  pass->SetDepthRange(vtkOITBucketPeelingPass::BOUNDS);
}
}

int TestPeelingStatistics(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Width, Height);
      for (const int layers : { 1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 17, 20, 2, 1, 40, 1 })
      {
        CheckCounts(report, rig, setup, layers);
      }
      CheckChanges(report, setup, 0);
      CheckChanges(report, setup, 1 << 20);
      CheckLayersPerPass(report, rig, setup);
      CheckSingleShot(report, rig, setup);
      CheckMovingFragments(report, rig);
      report.SetStressTest(30);
      CheckLimits(report, rig, setup);
    });
}
