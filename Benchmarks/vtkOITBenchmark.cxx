// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Times translucency methods side by side: one process, one window a method, alternating frames
// of a turning camera, medians. Ratios are against unsorted blending. Run it with -h for help.
#include "BenchmarkScenes.h"

#include "vtkOITHeadless.h"
#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTimerLog.h"
#include "vtkTranslucentPass.h"

#include <vtksys/CommandLineArguments.hxx>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
class Contender
{
public:
  Contender(const std::string& name, const BenchmarkScene& scene, int size)
    : Name(name)
  {
    this->Window->SetSize(size, size);
    this->Window->SetMultiSamples(0);
    this->Window->OffScreenRenderingOn();
    this->Window->AddRenderer(this->Renderer);
    scene.Fill(this->Renderer);
    if (name == "vtk-dual")
    {
      this->Renderer->UseDepthPeelingOn();
      this->Renderer->SetMaximumNumberOfPeels(1000);
      this->Renderer->SetOcclusionRatio(0.0);
    }
    else if (name != "vtk-weighted")
    {
      vtkNew<vtkRenderStepsPass> steps;
      if (name == "blend")
      {
        vtkNew<vtkTranslucentPass> blend;
        steps->SetTranslucentPass(blend);
      }
      else
      {
        this->Pass.TakeReference(vtkOITPassFactory::CreatePass(name));
        steps->SetTranslucentPass(this->Pass);
      }
      this->Renderer->SetPass(steps);
    }
  }

  void RenderFrame()
  {
    this->Renderer->GetActiveCamera()->Azimuth(0.5);
    const double start = vtkTimerLog::GetUniversalTime();
    const std::clock_t cpuStart = std::clock();
    this->Window->Render();
    this->Window->WaitForCompletion();
    this->CPUSeconds.push_back(double(std::clock() - cpuStart) / CLOCKS_PER_SEC);
    this->Seconds.push_back(vtkTimerLog::GetUniversalTime() - start);
  }

  void ForgetFrames()
  {
    this->Seconds.clear();
    this->CPUSeconds.clear();
  }

  std::string Name;
  vtkSmartPointer<vtkOITPass> Pass;
  std::vector<double> Seconds;
  std::vector<double> CPUSeconds; // of all threads; less disturbed by other processes

private:
  vtkNew<vtkRenderer> Renderer; // outlives the window, which is declared after it
  vtkNew<vtkRenderWindow> Window;
};

double GetQuantile(std::vector<double> values, double q)
{
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

void RunScene(
  const BenchmarkScene& scene, const std::vector<std::string>& methods, int size, int frames)
{
  std::vector<std::unique_ptr<Contender>> contenders;
  for (const std::string& method : methods)
  {
    contenders.push_back(std::make_unique<Contender>(method, scene, size));
    contenders.back()->RenderFrame(); // data, shaders and buffers are made here
    contenders.back()->RenderFrame();
    contenders.back()->ForgetFrames();
  }
  for (int frame = 0; frame < frames; ++frame)
  {
    for (auto& contender : contenders)
    {
      contender->RenderFrame();
    }
  }

  std::cout
    << "\n"
    << scene.Name << ": " << scene.Description << ", " << size << " x " << size << ", " << frames
    << " frames each\n"
    << "  method          ratio    spread  cpu ratio   ms/frame   passes  fragments  depth  MiB\n"
    << std::fixed;
  const double reference = GetQuantile(contenders.front()->Seconds, 0.5);
  const double cpuReference = GetQuantile(contenders.front()->CPUSeconds, 0.5);
  for (const auto& contender : contenders)
  {
    const double median = GetQuantile(contender->Seconds, 0.5);
    const double spread =
      (GetQuantile(contender->Seconds, 0.75) - GetQuantile(contender->Seconds, 0.25)) / median;
    std::cout << "  " << std::left << std::setw(14) << contender->Name << std::right
              << std::setprecision(2) << std::setw(7) << median / reference << std::setw(9)
              << std::setprecision(0) << 100.0 * spread << "%" << std::setprecision(2)
              << std::setw(11) << GetQuantile(contender->CPUSeconds, 0.5) / cpuReference
              << std::setprecision(1) << std::setw(11) << 1000.0 * median;
    if (vtkOITPass* pass = contender->Pass)
    {
      std::cout << std::setw(9) << pass->GetNumberOfGeometryPasses() << std::setw(11)
                << pass->GetNumberOfFragments() << std::setw(7) << pass->GetMaximumDepthComplexity()
                << std::setw(5) << pass->GetBufferSizeInBytes() / (1 << 20);
    }
    std::cout << std::endl;
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  std::vector<std::string> methods;
  std::vector<std::string> sceneNames;
  int size = 800;
  int frames = 15;
  bool help = false;
  vtksys::CommandLineArguments arguments;
  arguments.Initialize(argc, argv);
  using Arguments = vtksys::CommandLineArguments;
  arguments.AddArgument("--methods", Arguments::MULTI_ARGUMENT, &methods,
    "names as in vtkOITPassFactory, also vtk-weighted and vtk-dual; blend is always run");
  arguments.AddArgument(
    "--scenes", Arguments::MULTI_ARGUMENT, &sceneNames, "spheres, isosurfaces, deep; default all");
  arguments.AddArgument(
    "--size", Arguments::SPACE_ARGUMENT, &size, "pixels of a side, default 800");
  arguments.AddArgument("--frames", Arguments::SPACE_ARGUMENT, &frames, "per method, default 15");
  arguments.AddBooleanArgument("-h", &help, "this help");
  if (!arguments.Parse() || help || size < 1 || frames < 1)
  {
    std::cout << "usage: vtkOITBenchmark [options]\n" << arguments.GetHelp();
    return help ? 0 : 1;
  }
  if (methods.empty())
  {
    methods = { "vtk-weighted", "vtk-dual", "abuffer" };
  }
  for (const std::string& method : methods)
  {
    if (method.rfind("vtk-", 0) != 0 &&
      !vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass(method)))
    {
      std::cerr << "vtkOITBenchmark: there is no method " << method << "; see -h\n";
      return 1;
    }
  }
  methods.insert(methods.begin(), "blend");
  if (!vtkOITHeadless::Initialize())
  {
    return 1;
  }
  std::cout << "window: " << vtkOITHeadless::GetBackendName() << "\n";
  for (const BenchmarkScene& scene : GetBenchmarkScenes())
  {
    if (sceneNames.empty() ||
      std::find(sceneNames.begin(), sceneNames.end(), scene.Name) != sceneNames.end())
    {
      RunScene(scene, methods, size, frames);
    }
  }
  return 0;
}
