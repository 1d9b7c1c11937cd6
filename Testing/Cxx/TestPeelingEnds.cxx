// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Peeling ends although a prop draws past the pass, into what the peels are found from; where that
// has kept a peel from taking anything away, the frame is not exact and one line says so.

#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

using namespace vtkOITTest;

namespace
{
/// Draws an actor without handing on its property keys, as vtkAnnotatedCubeActor does.
class UnkeyedProp : public vtkProp
{
public:
  static UnkeyedProp* New();
  vtkTypeMacro(UnkeyedProp, vtkProp);

  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 1; }
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    return this->Actor->RenderTranslucentPolygonalGeometry(viewport);
  }
  double* GetBounds() override { return this->Actor->GetBounds(); }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Actor->ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkActor> Actor;
};
vtkStandardNewMacro(UnkeyedProp);

constexpr int FewPasses = 200;
}

int TestPeelingEnds(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      for (const float alpha : { 0.0f, 0.5f, 1.0f })
      {
        Rig rig(setup, 16, 12);
        for (const float depth : { 0.25f, 0.5f, 0.75f })
        {
          rig.AddQuad({ depth, { 0.2f, 0.4f, 0.8f, 0.5f } });
        }
        vtkNew<UnkeyedProp> prop;
        prop->Actor = rig.AddQuad({ 0.4f, { alpha, 0.9f, 0.3f, alpha } });
        prop->Actor->ForceTranslucentOn();
        rig.Renderer->RemoveActor(prop->Actor);
        rig.Renderer->AddViewProp(prop);
        const LineCatcher lines;
        for (int frame = 0; frame < 3; ++frame)
        {
          rig.RenderWindow();
          const int passes = rig.Pass->GetNumberOfGeometryPasses();
          report.Check(passes < FewPasses, std::to_string(passes) + " geometry passes");
        }
        report.Check(lines.GetTexts().size() <= 1, "more than one line" + lines.Describe());
        report.Check(lines.GetTexts().empty() || !rig.Pass->GetExact(), "exact" + lines.Describe());
      }
    });
}
