// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Each mapper builds its shaders once for a pass: not again in later frames, nor for stages or peels.
// Nor does anything else compile or link shaders once a scene has been seen.

#include "Rig/GLObjects.h"
#include "Rig/Rig.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "vtkOITBucketPeelingPass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

using namespace vtkOITTest;

namespace
{
int NumberOfBuilds = 0;

class CountingMapper : public vtkOpenGLPolyDataMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkOpenGLPolyDataMapper);

protected:
  CountingMapper() = default;
  ~CountingMapper() override = default;

  void BuildShaders(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    ++NumberOfBuilds;
    this->Superclass::BuildShaders(shaders, renderer, actor);
  }
};
vtkStandardNewMacro(CountingMapper);

int NumberOfCompilations = 0;

/// Counts what OpenGL is asked to compile and link, by whomever, while one lives.
class CompilationCounter
{
public:
  CompilationCounter()
  {
    Compile = glCompileShader;
    Link = glLinkProgram;
    glCompileShader = [](GLuint shader)
    {
      ++NumberOfCompilations;
      Compile(shader);
    };
    glLinkProgram = [](GLuint program)
    {
      ++NumberOfCompilations;
      Link(program);
    };
  }
  ~CompilationCounter()
  {
    glCompileShader = Compile;
    glLinkProgram = Link;
  }
  CompilationCounter(const CompilationCounter&) = delete;
  CompilationCounter& operator=(const CompilationCounter&) = delete;

private:
  static PFNGLCOMPILESHADERPROC Compile;
  static PFNGLLINKPROGRAMPROC Link;
};
PFNGLCOMPILESHADERPROC CompilationCounter::Compile = nullptr;
PFNGLLINKPROGRAMPROC CompilationCounter::Link = nullptr;

constexpr int NumberOfProps = 5;

void AddSpheres(Rig& rig)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  for (int i = 0; i < NumberOfProps; ++i)
  {
    vtkNew<CountingMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0.1 * i - 0.2, 0.0, 0.0);
    actor->GetProperty()->SetOpacity(i == 0 ? 1.0 : 0.1 + 0.2 * i); // one opaque
    actor->GetProperty()->SetLighting(i % 2 == 0);
    actor->GetProperty()->SetRepresentation(i == 3 ? VTK_WIREFRAME : VTK_SURFACE);
    rig.Renderer->AddActor(actor);
  }
}

/// Renders a scene anew, and then from where it has been seen.
void CheckReuse(Report& report, Rig& rig, const std::string& what, int expectedBuilds)
{
  NumberOfBuilds = 0;
  NumberOfCompilations = 0;
  const CompilationCounter counter;
  rig.Window->Render();
  report.Check(NumberOfBuilds == expectedBuilds,
    what + std::to_string(NumberOfBuilds) + " shader builds for " + std::to_string(expectedBuilds) +
      " props in the first frame");
  // Later setups share windows with earlier ones, and their programs.
  static int compilationsOfAllSetups = 0;
  compilationsOfAllSetups += NumberOfCompilations;
  report.Check(compilationsOfAllSetups > 0, what + "the counter does not count");
  const int builds = NumberOfBuilds;
  // Once around may need more memory and other stages for deeper pixels, but not a second time.
  GLObjectCounts counts[2];
  int compilations[2] = {};
  for (int round = 0; round < 2; ++round)
  {
    NumberOfCompilations = 0;
    for (int frame = 0; frame < 9; ++frame)
    {
      rig.Renderer->GetActiveCamera()->Azimuth(40.0);
      rig.Window->Render();
    }
    rig.Window->MakeCurrent();
    counts[round] = GLObjectCounts::OfCurrentContext();
    compilations[round] = NumberOfCompilations;
  }
  report.Check(NumberOfBuilds == builds,
    what + std::to_string(NumberOfBuilds - builds) + " shader builds in 18 later frames");
  report.Check(compilations[1] == 0,
    what + std::to_string(compilations[1]) + " compilations in 9 frames seen before");
  report.Check(counts[0] == counts[1],
    what + "9 frames seen before changed the objects from " + counts[0].Describe() + " to " +
      counts[1].Describe());
}
}

int TestShaderReuse(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 64, 48);
      rig.Window->Render(); // the loader finds OpenGL's functions
      AddSpheres(rig);
      CheckReuse(report, rig, "", NumberOfProps);
      if (auto* pass = vtkOITBucketPeelingPass::SafeDownCast(rig.Pass))
      {
        pass->SetMaximumNumberOfPeels(1);
        CheckReuse(report, rig, "single shot: ", NumberOfProps - 1); // the opaque one has its own
        pass->SetDepthRange(vtkOITBucketPeelingPass::EXACT);
        rig.Window->Render();
        NumberOfBuilds = 0;
        rig.Window->Render();
        report.Check(NumberOfBuilds == 0, "exact range: shaders are built anew");
      }
    });
}
