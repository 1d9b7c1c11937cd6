// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Which method the automatic pass takes, for which reason, and that it stays with it and within its
// memory.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkOITAutoPass.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <vtksys/SystemTools.hxx>

#include <set>

using namespace vtkOITTest;

namespace
{
constexpr vtkTypeInt64 MiB = INT64_C(1) << 20;

vtkOITAutoPass* GetPass(Rig& rig)
{
  return vtkOITAutoPass::SafeDownCast(rig.Pass);
}

void CheckEqual(
  Report& report, const std::string& what, const std::string& is, const std::string& expected)
{
  report.Check(is == expected, what + " is \"" + is + "\", expected \"" + expected + "\"");
}

void CheckLimit(Report& report, Rig& rig, const std::string& what)
{
  const vtkTypeInt64 bytes = rig.Pass->GetBufferSizeInBytes();
  report.Check(bytes > 0 && bytes <= GetPass(rig)->GetBufferLimit(),
    what + ": the pass holds " + std::to_string(bytes) + " bytes, the limit is " +
      std::to_string(GetPass(rig)->GetBufferLimit()));
}

/// Ramps that cross each other at the middle of the viewport, so that they must be sorted; and
/// what they are left and right of it.
struct Ramps
{
  std::vector<Layer> Left;
  std::vector<Layer> Right;

  Ramps(Rig& rig, int count)
  {
    Random random(8);
    for (int i = 0; i < count; ++i)
    {
      const auto depth = static_cast<float>(0.1 + 0.8 * (i + 0.5) / count);
      const glm::vec4 color(random.Uniform(), random.Uniform(), random.Uniform(), 0.3f);
      this->Left.push_back({ depth, color });
      this->Right.push_back({ 1.0f - depth, color });
    }
    random.Shuffle(this->Left);
    for (const Layer& layer : this->Left)
    {
      rig.AddRamp(layer.Depth, 1.0 - layer.Depth, layer.Color);
    }
  }

  Report::Expected GetExpected(const Rig& rig) const
  {
    const glm::dvec4 left = ReferenceCompositor::Composite(this->Left, rig.GetBackground());
    const glm::dvec4 right = ReferenceCompositor::Composite(this->Right, rig.GetBackground());
    const int middle = rig.GetWidth() / 2;
    return [left, right, middle](int x, int) { return x < middle ? left : right; };
  }
};

Tolerance GetBound(const Setup& setup, int layers)
{
  return ReferenceCompositor::RoundingBoundOfAnyStack(layers, setup.FragmentStorage);
}

void CheckNames(Report& report, const Setup& setup)
{
  Rig rig(setup, 32, 24);
  const Ramps ramps(rig, 6);
  for (int frame = 0; frame < 4; ++frame) // the first one makes default lookup tables
  {
    report.Compare("ramps", rig.Render(), ramps.GetExpected(rig), GetBound(setup, 6));
  }
  CheckEqual(report, "algorithm", rig.Pass->GetAlgorithmName(),
    setup.HasStorage ? "A-buffer" : "dual depth peeling");
  CheckEqual(report, "choice of a reused frame", GetPass(rig)->GetAlgorithmReason(),
    "nothing has changed since the last frame");
  GetPass(rig)->ReuseFramesOff();
  rig.Render();
  const std::string choice = GetPass(rig)->GetAlgorithmReason();
  if (setup.HasStorage)
  {
    CheckEqual(report, "choice", choice, "its fragments fit into memory");
  }
  else
  {
    report.Check(choice.find("lacks GL_ARB_") != std::string::npos, "choice is " + choice);
  }
  rig.RemoveProps();
  rig.AddQuad({ 0.5f, { 0.5f, 0.6f, 0.7f, 0.5f } });
  rig.Render();
  CheckEqual(report, "algorithm of a quad", rig.Pass->GetAlgorithmName(), "ordered blending");
  CheckEqual(
    report, "choice", GetPass(rig)->GetAlgorithmReason(), "the order of all props is known");

  // Sorted and blended props in one frame.
  rig.RemoveProps();
  rig.AddQuad({ 0.5f, { 0.5f, 0.6f, 0.7f, 0.5f } }, { 0, 0, 8, 24 });
  rig.AddQuad({ 0.5f, { 0.5f, 0.6f, 0.7f, 0.5f } }, { 16, 0, 32, 24 });
  rig.AddQuad({ 0.5f, { 0.5f, 0.6f, 0.7f, 0.5f } }, { 16, 0, 32, 24 });
  rig.Render();
  CheckEqual(report, "algorithm of both", rig.Pass->GetAlgorithmName(),
    setup.HasStorage ? "A-buffer" : "dual depth peeling");
  report.Check(rig.Pass->GetNumberOfFragments() == -1, "blended fragments are counted");
}

void CheckLimits(Report& report, const Setup& setup)
{
  Rig rig(setup, 32, 24);
  report.Check(GetPass(rig)->GetBufferLimit() == 1024 * MiB, "the limit before the first frame");
  rig.AddQuad({ 0.5f, { 0.5f, 0.6f, 0.7f, 0.5f } });
  rig.Render();
  const vtkTypeInt64 limit = GetPass(rig)->GetBufferLimit();
  report.Check(limit > 0 && limit <= 1024 * MiB, "the limit is " + std::to_string(limit));
  GetPass(rig)->SetMaximumBufferSize(5 * MiB);
  report.Check(GetPass(rig)->GetBufferLimit() == 5 * MiB, "the limit is not the one that was set");
}

/// More fragments than fit into the memory, of still and of moving frames.
void CheckSmallMemory(Report& report, const Setup& setup, int width, int height, int layers)
{
  Rig rig(setup, width, height);
  const std::string what = std::to_string(width) + "x" + std::to_string(height) + ", " +
    std::to_string(layers) + " layers";
  GetPass(rig)->SetMaximumBufferSize(MiB);
  const Ramps ramps(rig, layers);
  std::set<std::string> names;
  std::vector<int> passes;
  for (int frame = 0; frame < 10; ++frame)
  {
    GetPass(rig)->SetReuseFrames(frame < 4);
    const Image image = rig.Render();
    if (frame % 3 == 0)
    {
      report.Compare(what, image, ramps.GetExpected(rig), GetBound(setup, layers));
    }
    // The first frame finds out how many bands there are, and may hold heads of larger ones; dual
    // depth peeling needs what it needs.
    if (frame > 0 && setup.HasStorage)
    {
      CheckLimit(report, rig, what);
    }
    if (frame >= 5)
    {
      names.insert(rig.Pass->GetAlgorithmName());
      passes.push_back(rig.Pass->GetNumberOfGeometryPasses());
    }
  }
  report.Check(names.size() == 1, what + ": the method changes from frame to frame");
  report.Check(!setup.HasStorage || names.count("A-buffer") > 0,
    what + ": drawn by " + *names.begin() + ", which needs more passes");
  std::printf("%s: %s, %d geometry passes: %s\n", what.c_str(), names.begin()->c_str(),
    passes.back(), GetPass(rig)->GetAlgorithmReason().c_str());
  if (setup.HasStorage)
  {
    CheckEqual(report, what + ": choice", GetPass(rig)->GetAlgorithmReason(),
      "in bands, as its fragments do not fit into memory");
  }
  report.Check(std::set<int>(passes.begin(), passes.end()).size() == 1,
    what + ": the number of geometry passes changes from frame to frame");
}

/// The heads of all pixels would take the whole limit, but those of a band do not.
void CheckManyPixels(Report& report, const Setup& setup)
{
  Rig rig(setup, 520, 520);
  GetPass(rig)->SetMaximumBufferSize(MiB);
  GetPass(rig)->ReuseFramesOff();
  const Ramps ramps(rig, 3);
  for (int frame = 0; frame < 3; ++frame)
  {
    report.Compare("many pixels", rig.Render(), ramps.GetExpected(rig), GetBound(setup, 3));
    CheckEqual(report, "algorithm of many pixels", rig.Pass->GetAlgorithmName(), "A-buffer");
  }
}

/// A limit that is set when there are large buffers already.
void CheckLoweredLimit(Report& report, const Setup& setup)
{
  if (!setup.HasStorage)
  {
    return;
  }
  Rig rig(setup, 160, 120);
  const Ramps ramps(rig, 12);
  for (int frame = 0; frame < 3; ++frame)
  {
    rig.Render();
  }
  const vtkTypeInt64 before = rig.Pass->GetBufferSizeInBytes();
  report.Check(before > 3 * MiB, "without a limit: only " + std::to_string(before) + " bytes");
  GetPass(rig)->SetMaximumBufferSize(MiB);
  for (int frame = 0; frame < 4; ++frame)
  {
    report.Compare("lowered limit", rig.Render(), ramps.GetExpected(rig), GetBound(setup, 12));
    CheckLimit(report, rig, "lowered limit, frame " + std::to_string(frame));
  }
  GetPass(rig)->SetMaximumBufferSize(0);
  report.Compare("limit gone", rig.Render(), ramps.GetExpected(rig), GetBound(setup, 12));

  // The same for planes, which are blended while there is memory for it.
  rig.RemoveProps();
  const std::vector<Layer> layers = Random(9).Layers(9);
  for (const Layer& layer : layers)
  {
    rig.AddQuad(layer);
  }
  const Report::Expected expected =
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
  for (const vtkTypeInt64 limit : { 0 * MiB, 1 * MiB, 2 * MiB })
  {
    GetPass(rig)->SetMaximumBufferSize(limit);
    for (int frame = 0; frame < 3; ++frame)
    {
      const std::string what = "planes in " + std::to_string(limit / MiB) + " MiB";
      report.Compare(what, rig.Render(), expected, GetBound(setup, 9));
      CheckLimit(report, rig, what);
    }
  }
}

/// Without storage for fragments in the middle of a life, and with it again.
void CheckFallbacks(Report& report, const Setup& setup)
{
  for (const char* hidden : { "GL_ARB_shader_storage_buffer_object",
         "GL_ARB_shader_image_load_store GL_EXT_shader_framebuffer_fetch", "GL_ARB_gpu_shader5" })
  {
    vtksys::SystemTools::PutEnv(std::string("VTKOIT_HIDE_EXTENSIONS=") + hidden);
    Rig rig(setup, 32, 24);
    GetPass(rig)->ReuseFramesOff();
    const Ramps ramps(rig, 5);
    std::set<std::string> names;
    for (int frame = 0; frame < 3; ++frame)
    {
      report.Compare(
        std::string("without ") + hidden, rig.Render(), ramps.GetExpected(rig), GetBound(setup, 5));
      names.insert(rig.Pass->GetAlgorithmName());
    }
    const bool isHalf = setup.FragmentStorage == Storage::Half;
    report.Check(names.size() == 1 && names.count("A-buffer") == 0 &&
        (isHalf || names.count("dual depth peeling") > 0),
      std::string("without ") + hidden + ": drawn by " + *names.begin());
    report.Check(GetPass(rig)->GetAlgorithmReason().find("lacks GL_") != std::string::npos,
      std::string("without ") + hidden + ": the choice is " + GetPass(rig)->GetAlgorithmReason());
  }
  vtksys::SystemTools::PutEnv("VTKOIT_HIDE_EXTENSIONS=");
}
}

int TestAutoPassChoice(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      CheckNames(report, setup);
      CheckLimits(report, setup);
      CheckSmallMemory(report, setup, 64, 48, 40);
      CheckSmallMemory(report, setup, 200, 150, 20);
      CheckSmallMemory(report, setup, 300, 200, 4);
      if (setup.HasStorage && setup.FragmentStorage == Storage::Half)
      {
        CheckManyPixels(report, setup);
      }
      CheckLoweredLimit(report, setup);
      if (setup.Tier == "all extensions")
      {
        CheckFallbacks(report, setup);
      }
    });
}
