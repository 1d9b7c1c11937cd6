// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/Contenders.h"

#include "Rig/GLObjects.h"
#include "Rig/Rig.h"

#include "vtkDepthPeelingPass.h"
#include "vtkNew.h"
#include "vtkOITABufferPass.h"
#include "vtkOITHeadless.h"
#include "vtkOITPassFactory.h"
#include "vtkOITRendererHook.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace vtkOITTest
{
namespace
{
const char* const Names[] = { "vtk-weighted", "vtk-dual", "vtk-dual-4", "vtk-peel" };

/// More than any scene has layers. VTK's dual pass takes 0, "no limit", for no peels at all.
constexpr int AllPeels = 100000;

std::string Quote(const std::string& text)
{
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return quoted + "\"";
}

/// JSON has no infinity: 1e30 for a number that is not finite.
std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", std::isfinite(value) ? value : 1e30);
  return text;
}

/// The renderer's string of a window, for example "llvmpipe (...)".
std::string FindGLRenderer()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(8, 8);
  window->AddRenderer(vtkNew<vtkRenderer>());
  window->Render();
  window->MakeCurrent();
  const char* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name ? name : "unknown";
}

bool Append(const std::string& fileName, const std::string& test, const std::string& contender,
  const std::vector<Report::Result>& results)
{
  std::FILE* file = std::fopen(fileName.c_str(), "a");
  if (!file)
  {
    std::printf(
      "FAILED: cannot write to %s; give a file in a folder that exists\n", fileName.c_str());
    return false;
  }
  std::fprintf(file, "{\"vtk\": %s, \"renderer\": %s}\n",
    Quote(vtkVersion::GetVTKVersion()).c_str(), Quote(FindGLRenderer()).c_str());
  for (const Report::Result& result : results)
  {
    std::fprintf(file,
      "{\"test\": %s, \"number\": %d, \"contender\": %s, \"what\": %s, \"color\": %s, "
      "\"alpha\": %s, \"allowed_color\": %s, \"allowed_alpha\": %s, \"picture\": %s}\n",
      Quote(test).c_str(), result.StressTest, Quote(contender).c_str(), Quote(result.What).c_str(),
      Number(result.Error.Color).c_str(), Number(result.Error.Alpha).c_str(),
      Number(result.Allowed.Color).c_str(), Number(result.Allowed.Alpha).c_str(),
      Quote(result.Picture).c_str());
  }
  return std::fclose(file) == 0;
}
}

//------------------------------------------------------------------------------
std::string GetOption(int argc, char* argv[], const std::string& name)
{
  for (int i = 2; i + 1 < argc; ++i)
  {
    if (argv[i] == name)
    {
      return argv[i + 1];
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool IsContender(const std::string& name)
{
  return std::find(std::begin(Names), std::end(Names), name) != std::end(Names);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkOITPass> CreateContenderPass(const std::string& name)
{
  // VTK's are attached without one; the tests set properties of some pass all the same.
  return IsContender(name) ? vtkSmartPointer<vtkOITPass>(vtkSmartPointer<vtkOITABufferPass>::New())
                           : vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass(name));
}

//------------------------------------------------------------------------------
void AttachContender(const std::string& name, vtkRenderer* renderer, vtkOITPass* pass)
{
  const bool isDualOfFour = name == "vtk-dual-4";
  renderer->SetUseDepthPeeling(name == "vtk-dual" || isDualOfFour);
  renderer->SetMaximumNumberOfPeels(isDualOfFour ? 4 : AllPeels);
  renderer->SetOcclusionRatio(0.0);
  if (name == "vtk-peel")
  {
    vtkNew<vtkDepthPeelingPass> peeling;
    peeling->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
    peeling->SetMaximumNumberOfPeels(AllPeels);
    peeling->SetOcclusionRatio(0.0);
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetTranslucentPass(peeling);
    renderer->SetPass(steps);
  }
  else if (!IsContender(name))
  {
    vtkOITRendererHook::Install(renderer, pass);
  }
}

//------------------------------------------------------------------------------
void DetachContender(vtkRenderer* renderer)
{
  vtkOITRendererHook::Uninstall(renderer);
  if (renderer->GetPass() && renderer->GetVTKWindow())
  {
    renderer->GetPass()->ReleaseGraphicsResources(renderer->GetVTKWindow());
  }
  renderer->SetPass(nullptr);
  renderer->SetUseDepthPeeling(0);
}

//------------------------------------------------------------------------------
std::vector<Report::Result> ObserveContender(const std::string& name,
  const std::function<void(Report&, const Setup&)>& body, const std::string& pictures)
{
  Setup setup;
  setup.Method = name;
  setup.IsContender = true;
  setup.FragmentStorage = Storage::Float32;
  setup.LargestStack = 1000;
  Report report;
  report.SetContext(name);
  report.Observe({ 3.0 / 255, 3.0 / 255 }, pictures);
  body(report, setup);
  return report.GetResults();
}

//------------------------------------------------------------------------------
int RunContender(int argc, char* argv[], const std::function<void(Report&, const Setup&)>& body)
{
  if (!vtkOITHeadless::Initialize())
  {
    std::printf("FAILED: no headless render window; see the error above\n");
    return EXIT_FAILURE;
  }
  if (!CreateContenderPass(argv[1]))
  {
    std::printf("FAILED: no method is called %s\n", argv[1]);
    return EXIT_FAILURE;
  }
  const std::string file = GetOption(argc, argv, "--results");
  const std::vector<Report::Result> results =
    ObserveContender(argv[1], body, GetOption(argc, argv, "--pictures"));
  if (!file.empty() && !Append(file, argv[0], argv[1], results))
  {
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
}
