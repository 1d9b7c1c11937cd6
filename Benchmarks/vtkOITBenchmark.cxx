// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Times translucency methods side by side: one process, one window a method, alternating frames
// of a turning camera, medians. Ratios are against unsorted blending. The GPU's time is from the
// first to the last command of a frame, by timer queries. Run it with -h for help.
#include "BenchmarkScenes.h"

#include "vtkOITHeadless.h"
#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"

#include "vtkCamera.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"
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
constexpr int NothingToDrawWith = 77; // the exit status without EGL and OSMesa

// Mesa's software renderers answer timer queries with times that miss part of the frame.
bool HasTimerQueries = false;

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
    vtkOpenGLRenderTimer timer; // of this frame only, so that it ends while its context is current
    const bool timed = HasTimerQueries && !this->Window->GetNeverRendered();
    if (timed)
    {
      this->Window->MakeCurrent();
      timer.Start();
    }
    const double start = vtkTimerLog::GetUniversalTime();
    const std::clock_t cpuStart = std::clock();
    this->Window->Render();
    if (timed)
    {
      timer.Stop();
    }
    this->Window->WaitForCompletion();
    this->CPUSeconds.push_back(double(std::clock() - cpuStart) / CLOCKS_PER_SEC);
    this->Seconds.push_back(vtkTimerLog::GetUniversalTime() - start);
    this->GPUSeconds.push_back(timed && timer.Ready() ? timer.GetElapsedSeconds() : 0.0);
  }

  void ForgetFrames()
  {
    this->Seconds.clear();
    this->CPUSeconds.clear();
    this->GPUSeconds.clear();
  }

  std::string Name;
  vtkSmartPointer<vtkOITPass> Pass;
  std::vector<double> Seconds;
  std::vector<double> CPUSeconds; // of all threads; less disturbed by other processes
  std::vector<double> GPUSeconds; // first to last command of a frame, by timer queries

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

// A dash without timer queries, or where the driver answers zero.
void PrintGPUTime(double seconds, double reference)
{
  if (seconds > 0.0 && reference > 0.0)
  {
    std::cout << std::setprecision(2) << std::setw(11) << seconds / reference
              << std::setprecision(3) << std::setw(9) << 1000.0 * seconds;
  }
  else
  {
    std::cout << std::setw(11) << "-" << std::setw(9) << "-";
  }
}

// Chooses the window, and prints what draws in it; without any, one line that says why.
bool SetUpWindows()
{
  vtkNew<vtkStringOutputWindow> messages;
  const vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkOutputWindow::SetInstance(messages);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  const bool works = vtkOITHeadless::Initialize();
  vtkLogger::SetStderrVerbosity(verbosity);
  vtkOutputWindow::SetInstance(nullptr);
  if (!works)
  {
    const std::string text = messages->GetOutput();
    const std::size_t start = text.find("vtkOITHeadless: ");
    std::cerr << "vtkOITBenchmark: nothing to draw with: "
              << (start == std::string::npos
                     ? text
                     : text.substr(start + 16, text.find('\n', start) - start - 16))
              << std::endl;
    return false;
  }

  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->Render();
  const std::string report = window->ReportCapabilities();
  std::cout << "window: " << vtkOITHeadless::GetBackendName();
  for (const std::string name : { "OpenGL renderer", "OpenGL version" })
  {
    std::size_t start = report.find(name + " string:");
    if (start != std::string::npos)
    {
      start = report.find_first_not_of(' ', start + name.size() + 8);
      std::cout << ", " << name << " " << report.substr(start, report.find('\n', start) - start);
    }
  }
  std::cout << std::endl;
  HasTimerQueries = report.find("llvmpipe") == std::string::npos &&
    report.find("softpipe") == std::string::npos && report.find("swrast") == std::string::npos;
  return true;
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

  std::cout << "\n"
            << scene.Name << ": " << scene.Description << ", " << size << " x " << size << ", "
            << frames << " frames each\n"
            << "  method          ratio    spread  cpu ratio   ms/frame  gpu ratio   gpu ms   "
               "passes  fragments  depth  MiB\n"
            << std::fixed;
  const double reference = GetQuantile(contenders.front()->Seconds, 0.5);
  const double cpuReference = GetQuantile(contenders.front()->CPUSeconds, 0.5);
  const double gpuReference = GetQuantile(contenders.front()->GPUSeconds, 0.5);
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
    PrintGPUTime(GetQuantile(contender->GPUSeconds, 0.5), gpuReference);
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
    "names as in vtkOITPassFactory, also vtk-weighted and vtk-dual; blend is always run; default "
    "vtk-weighted vtk-dual abuffer auto");
  arguments.AddArgument(
    "--scenes", Arguments::MULTI_ARGUMENT, &sceneNames, "spheres, isosurfaces, deep; default all");
  arguments.AddArgument(
    "--size", Arguments::SPACE_ARGUMENT, &size, "pixels of a side, default 800");
  arguments.AddArgument("--frames", Arguments::SPACE_ARGUMENT, &frames, "per method, default 15");
  arguments.AddBooleanArgument("-h", &help, "this help");
  arguments.AddBooleanArgument("--help", &help, "this help");
  if (!arguments.Parse() || help || size < 1 || frames < 1)
  {
    std::cout << "usage: vtkOITBenchmark [options]\n" << arguments.GetHelp();
    return help ? 0 : 1;
  }
  if (methods.empty())
  {
    methods = { "vtk-weighted", "vtk-dual", "abuffer", "auto" };
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
  if (!SetUpWindows())
  {
    return NothingToDrawWith;
  }
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
