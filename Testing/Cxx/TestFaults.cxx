// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Every OpenGL call of a method that can fail does so, once and from then on, in a new window and in
// one that has become larger. The picture is right, or the frame is not exact and one line says so;
// without the fault the next frame is right again, and no line is printed twice.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/FaultInjector.h"
#include "Rig/GLMessages.h"
#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 24;
constexpr int Height = 20;
constexpr int Frames =
  3; // an automatic pass keeps a layer in the second and reuses it in the third

/// Two ramps that cross, and quads before, between and behind them: some are in a known order, the
/// others not. Depths are equal nowhere, and the order changes between two columns.
const std::vector<Layer> Quads{ { 0.125f, { 0.9f, 0.2f, 0.1f, 0.4f } },
  { 0.5f, { 0.2f, 0.8f, 0.3f, 0.6f } }, { 0.875f, { 0.3f, 0.3f, 0.9f, 0.5f } } };
const std::vector<glm::vec4> RampColors{ { 0.8f, 0.8f, 0.1f, 0.5f }, { 0.1f, 0.7f, 0.9f, 0.3f } };

/// What else than the layers in the middle of the scene is drawn.
enum class Scene
{
  Crossing, // quads and ramps
  Ordered   // the quads alone
};

void AddScene(Rig& rig, Scene scene)
{
  rig.AddStack(Quads);
  if (scene == Scene::Crossing)
  {
    rig.AddRamp(0.25, 0.75, RampColors[0])->ForceTranslucentOn();
    rig.AddRamp(0.75, 0.25, RampColors[1])->ForceTranslucentOn();
  }
}

Report::Expected MakeTruth(Scene scene, const glm::dvec4& background, int width)
{
  std::vector<glm::dvec4> halves;
  for (const bool isRight : { false, true })
  {
    std::vector<Layer> layers = Quads;
    if (scene == Scene::Crossing)
    {
      layers.push_back({ isRight ? 0.6f : 0.4f, RampColors[0] });
      layers.push_back({ isRight ? 0.4f : 0.6f, RampColors[1] });
    }
    halves.push_back(ReferenceCompositor::Composite(layers, background));
  }
  return [halves, width](int x, int) { return halves[x < width / 2 ? 0 : 1]; };
}

bool IsClose(const Image& image, const Report::Expected& expected, const Tolerance& tolerance)
{
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const glm::dvec4 difference = glm::dvec4(image.At(x, y)) - expected(x, y);
      for (int channel = 0; channel < 4; ++channel)
      {
        const double allowed = channel == 3 ? tolerance.Alpha : tolerance.Color;
        if (!(std::abs(difference[channel]) <= allowed))
        {
          return false;
        }
      }
    }
  }
  return !image.Pixels.empty();
}

/// One scene of a method, drawn again and again under faults.
class Attack
{
public:
  Attack(Report& report, const Setup& setup, Scene scene, int samples, bool resizes = false)
    : TheReport(report)
    , TheSetup(setup)
    , TheScene(scene)
    , Samples(samples)
    , Resizes(resizes)
    , Allowed(ReferenceCompositor::RoundingBoundOfAnyStack(5, setup.FragmentStorage) +
        Rig::WindowTolerance())
    , What((scene == Scene::Crossing ? "crossing, " : "ordered, ") + std::to_string(samples) +
        " samples" + (resizes ? ", larger than before" : ""))
  {
  }

  void Run()
  {
    this->DrawWithoutFault();
    const std::array<int, FaultInjector::NumberOfKinds> calls = this->NumberOfCalls;
    std::string counts;
    for (int kind = 0; kind < FaultInjector::NumberOfKinds; ++kind)
    {
      counts += std::string(" ") + FaultInjector::GetName(FaultInjector::Kind(kind)) + " " +
        std::to_string(calls[kind]);
      // How often results are asked for depends on the pace of the driver: the first ones stand for all.
      const int last = kind == FaultInjector::Query ? std::min(calls[kind], 8) : calls[kind];
      for (int number = 1; number <= last; ++number)
      {
        for (const bool fromThenOn : { false, true })
        {
          this->DrawWithFault(FaultInjector::Kind(kind), number, fromThenOn);
        }
      }
    }
    std::printf(
      "%s, %s: calls%s\n", this->TheSetup.Describe().c_str(), this->What.c_str(), counts.c_str());
  }

  /// A shader of an actor that compiles as it is, but not with a stage of ours, however the user
  /// has changed it: before VTK's own replacements, or after all of them.
  void DrawWithBrokenShader(bool isBefore)
  {
    const std::string what = this->What + ", a shader that does not compile with ours, " +
      (isBefore ? "before" : "after") + " VTK's replacements: ";
    Rig rig(this->TheSetup, Width, Height);
    this->Begin(rig, true);
    vtkActor* actor = rig.Renderer->GetActors()->GetLastActor();
    const LineCatcher catcher(this->UsualLines);
    const GLMessages::Pause pause; // the compiler's words
    for (const bool isBroken : { false, true, true, false })
    {
      vtkShaderProperty* shaders = actor->GetShaderProperty();
      shaders->ClearAllFragmentShaderReplacements();
      if (isBroken)
      {
        const std::string place = isBefore ? "//VTK::Normal::Dec" : "//VTK::System::Dec";
        shaders->AddFragmentShaderReplacement(
          place, isBefore, place + "\nvec4 oitFragColor;\n", false);
      }
      const Frame drawn = this->Draw(rig);
      this->TheReport.Check(isBroken ? !drawn.IsExact && !catcher.GetTexts().empty()
                                     : drawn.IsRight && drawn.IsExact == this->IsUsuallyExact,
        what + (isBroken ? "not said" : "not right without it"));
    }
    this->TheReport.Check(
      catcher.GetTexts().size() == 1, what + "not one line" + catcher.Describe());
    rig.Window->SetMultiSamples(0);
  }

private:
  struct Frame
  {
    Image Picture;
    bool IsRight = false;
    bool IsExact = false;
  };

  /// In the window of the run before; with nothing compiled, when that is to be seen.
  void Begin(Rig& rig, bool compiles) const
  {
    rig.Window->SetMultiSamples(this->Samples);
    rig.Pass->SetTransmittanceThreshold(0.0);
    rig.Renderer->SetDraw(false); // no pass of ours yet
    rig.Window->Render();
    rig.Renderer->SetDraw(true);
    if (compiles)
    {
      rig.GetGLWindow()->GetShaderCache()->ReleaseGraphicsResources(rig.Window);
    }
    AddScene(rig, this->TheScene);
    FaultInjector::Install();
  }

  /// Draws a frame, and makes the window larger.
  void Resize(Rig& rig) const
  {
    if (this->Resizes)
    {
      rig.RenderWindow();
      rig.SetSize(2 * Width, 2 * Height);
    }
  }

  Frame Draw(Rig& rig) const
  {
    const Image image = rig.RenderWindow();
    const bool isRight =
      IsClose(image, MakeTruth(this->TheScene, rig.GetBackground(), rig.GetWidth()), this->Allowed);
    // A preview is right as it is without a fault; another method than its own is right, too.
    const Image& usual = this->Usual;
    const bool isUsual = !usual.Pixels.empty() &&
      IsClose(
        image, [&usual](int x, int y) { return glm::dvec4(usual.At(x, y)); }, this->Allowed);
    return { image, isRight || (this->TheSetup.Promise == Expectation::Preview && isUsual),
      rig.Pass->GetExact() };
  }

  void DrawWithoutFault()
  {
    Rig rig(this->TheSetup, Width, Height);
    this->Begin(rig, true);
    this->Resize(rig);
    const LineCatcher lines;
    FaultInjector::Reset();
    for (int frame = 0; frame < Frames; ++frame)
    {
      const Frame drawn = this->Draw(rig);
      this->Usual = drawn.Picture;
      this->IsUsuallyExact = drawn.IsExact;
      this->TheReport.Check(drawn.IsRight || this->TheSetup.Promise == Expectation::Preview,
        this->What + ": wrong without any fault");
    }
    this->UsualLines = lines.GetTexts();
    for (int kind = 0; kind < FaultInjector::NumberOfKinds; ++kind)
    {
      this->NumberOfCalls[kind] = FaultInjector::GetNumberOfCalls(FaultInjector::Kind(kind));
    }
    rig.Window->SetMultiSamples(0);
  }

  void DrawWithFault(FaultInjector::Kind kind, int number, bool fromThenOn)
  {
    const std::string fault = this->What + ", " + FaultInjector::GetName(kind) + " call " +
      std::to_string(number) + (fromThenOn ? " and all after it" : "") + ", frame ";
    Rig rig(this->TheSetup, Width, Height);
    this->Begin(rig, kind == FaultInjector::Compile || kind == FaultInjector::Link);
    this->Resize(rig);
    const LineCatcher catcher(this->UsualLines);
    FaultInjector::Fail(kind, number, fromThenOn);
    int hits = 0;
    for (int frame = 0; frame <= Frames; ++frame)
    {
      if (frame == Frames)
      {
        FaultInjector::Reset();
      }
      const int before = FaultInjector::GetNumberOfFaults();
      const std::size_t linesBefore = catcher.GetTexts().size();
      const Frame drawn = this->Draw(rig);
      const bool isHit = FaultInjector::GetNumberOfFaults() > before;
      hits += isHit ? 1 : 0;
      const std::string what = fault + std::to_string(frame) + ": ";
      const bool isUsual = drawn.IsRight && drawn.IsExact == this->IsUsuallyExact;
      if (isHit)
      {
        this->TheReport.Check(drawn.IsRight || (!drawn.IsExact && !catcher.GetTexts().empty()),
          what + (drawn.IsExact ? "wrong and exact" : "wrong without a line"));
      }
      else
      {
        this->TheReport.Check(isUsual,
          what + (drawn.IsRight ? "not exact" : "wrong") + " without a fault, by " +
            rig.Pass->GetAlgorithmName());
        this->TheReport.Check(
          catcher.GetTexts().size() == linesBefore, what + "a line without a fault");
      }
    }
    this->TheReport.Check(hits > 0, fault + "*: there was no such call");
    // What was compiled before the window grew draws a part of the first frame, and no later one: two
    // things to say, each of them once.
    const std::size_t mostLines = this->Resizes && fromThenOn ? 2 : 1;
    const std::vector<std::string>& lines = catcher.GetTexts();
    this->TheReport.Check(
      lines.size() <= mostLines, fault + "*: more lines than one" + catcher.Describe());
    this->TheReport.Check(std::set<std::string>(lines.begin(), lines.end()).size() == lines.size(),
      fault + "*: a line again" + catcher.Describe());
    rig.Window->SetMultiSamples(0);
  }

  Report& TheReport;
  const Setup& TheSetup;
  Scene TheScene;
  int Samples;
  bool Resizes;
  Tolerance Allowed;
  std::string What;
  Image Usual; // without a fault
  bool IsUsuallyExact = true;
  std::vector<std::string> UsualLines;
  std::array<int, FaultInjector::NumberOfKinds> NumberOfCalls{};
};
}

int TestFaults(int argc, char* argv[])
{
  const std::string missing = FaultInjector::FindMissing();
  if (!missing.empty())
  {
    std::printf("skipped: %s\n", missing.c_str());
    return VTK_SKIP_RETURN_CODE;
  }
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      if (setup.FragmentStorage == Storage::Float32 && setup.Method != "peel" &&
        setup.LargestStack != 65 && setup.Promise == Expectation::Exact)
      {
        return; // the same calls as for half floats
      }
      for (const int samples : { 0, 4 })
      {
        if (samples > 0 && !setup.HasStorage)
        {
          continue; // no method resolves samples there
        }
        Attack attack(report, setup, Scene::Crossing, samples);
        attack.Run();
        attack.DrawWithBrokenShader(true);
        attack.DrawWithBrokenShader(false);
        if (samples == 0)
        {
          Attack(report, setup, Scene::Crossing, samples, true).Run();
        }
        if (setup.Method == "auto")
        {
          Attack(report, setup, Scene::Ordered, samples).Run();
        }
      }
    });
}
