// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Each mapper builds its shaders once for a pass: not again in later frames, nor for stages. The
// exception is adaptive bucket peeling, whose histogram has integer outputs: there mappers look
// their shaders up anew twice a peel, among the programs that the window's cache holds already.

#include "Rig/GLObjects.h"
#include "Rig/Rig.h"

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
}

int TestShaderReuse(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 64, 48);
      AddSpheres(rig);
      NumberOfBuilds = 0;
      rig.Window->Render();
      const bool exchangesShaders = setup.Method == "bucket-adaptive";
      report.Check(
        exchangesShaders ? NumberOfBuilds > NumberOfProps : NumberOfBuilds == NumberOfProps,
        std::to_string(NumberOfBuilds) + " shader builds for " + std::to_string(NumberOfProps) +
          " props in the first frame");
      const int builds = NumberOfBuilds;
      // Once around may need more memory and other stages for deeper pixels, but not a second time.
      GLObjectCounts counts[2];
      for (GLObjectCounts& count : counts)
      {
        for (int frame = 0; frame < 9; ++frame)
        {
          rig.Renderer->GetActiveCamera()->Azimuth(40.0);
          rig.Window->Render();
        }
        rig.Window->MakeCurrent();
        count = GLObjectCounts::OfCurrentContext();
      }
      report.Check(exchangesShaders || NumberOfBuilds == builds,
        std::to_string(NumberOfBuilds - builds) + " shader builds in 18 later frames");
      report.Check(counts[0] == counts[1],
        "9 frames seen before changed the objects from " + counts[0].Describe() + " to " +
          counts[1].Describe());
    });
}
