// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Peeling ends although a prop draws past the pass, into what the peels are found from; where that
// has kept a peel from taking anything away, the frame is not exact and one line says so. A prop that
// turns depth on after it has drawn, as vtkImageActor does, is peeled as any other. So it is
// when the application counts samples around the frame, and peeling cannot: the picture is right, or
// not exact, and the application has its count.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/GLObjects.h"
#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
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

void BeginQuery(vtkObject*, unsigned long, void* query, void*)
{
  glBeginQuery(GL_SAMPLES_PASSED, *static_cast<GLuint*>(query));
}

void EndQuery(vtkObject*, unsigned long, void*, void*)
{
  glEndQuery(GL_SAMPLES_PASSED);
}

void CheckQueryOfApplication(Report& report, const Setup& setup)
{
  const std::vector<Layer> layers{ { 0.25f, { 0.9f, 0.2f, 0.1f, 0.4f } },
    { 0.5f, { 0.2f, 0.8f, 0.3f, 0.6f } }, { 0.75f, { 0.3f, 0.3f, 0.9f, 0.5f } } };
  Rig rig(setup, 16, 12);
  rig.AddStack(layers);
  const LineCatcher lines;
  rig.Render(); // makes the context
  GLuint query = 0;
  glGenQueries(1, &query);
  vtkNew<vtkCallbackCommand> begin;
  begin->SetCallback(&BeginQuery);
  begin->SetClientData(&query);
  vtkNew<vtkCallbackCommand> end;
  end->SetCallback(&EndQuery);
  const unsigned long first = rig.Renderer->AddObserver(vtkCommand::StartEvent, begin);
  const unsigned long last = rig.Renderer->AddObserver(vtkCommand::EndEvent, end);
  for (int frame = 0; frame < 2; ++frame)
  {
    const Image image = rig.Render();
    GLuint samples = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
    report.Check(samples > 0, "the application counts nothing");
    if (rig.Pass->GetExact())
    {
      report.Compare("while the application counts samples", image,
        Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
        ReferenceCompositor::RoundingBoundOfAnyStack(3, setup.FragmentStorage));
    }
  }
  report.Check(lines.GetTexts().size() == 1, "not one line" + lines.Describe());
  rig.Renderer->RemoveObserver(first);
  rig.Renderer->RemoveObserver(last);
  glDeleteQueries(1, &query);
}

/// An image directly behind a quad, in one bucket with it, and another quad far behind. The image is drawn last.
void CheckImage(Report& report, const Setup& setup)
{
  const std::vector<Layer> layers{ { 0.5f, { 0.9f, 0.2f, 0.1f, 0.4f } },
    { 0.5f + 1.0f / (1 << 24), { 0.2f, 0.8f, 0.4f, 0.6f } },
    { 0.75f, { 0.3f, 0.3f, 0.9f, 0.5f } } };
  Rig rig(setup, 16, 12);
  rig.AddQuad(layers[0]);
  rig.AddQuad(layers[2]);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 16; ++i)
  {
    image->SetScalarComponentFromFloat(
      (i / 4) % 2, i / 8, 0, i % 4, 255.0 * layers[1].Color[i % 4]);
  }
  const glm::dvec3 first = rig.ToWorld(-16.0, -12.0, layers[1].Depth);
  const glm::dvec3 last = rig.ToWorld(32.0, 24.0, layers[1].Depth);
  image->SetOrigin(first.x, first.y, first.z);
  image->SetSpacing(last.x - first.x, last.y - first.y, 1.0);
  vtkNew<vtkImageActor> actor;
  actor->SetInputData(image);
  actor->ForceTranslucentOn();
  rig.Renderer->AddActor(actor);
  rig.Pass->SetTransmittanceThreshold(0.0);
  for (int frame = 0; frame < 3; ++frame)
  {
    report.Compare("an image behind a quad", rig.Render(),
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBoundOfAnyStack(3, setup.FragmentStorage));
    const int passes = rig.Pass->GetNumberOfGeometryPasses();
    report.Check(passes < FewPasses, std::to_string(passes) + " geometry passes");
    report.Check(rig.Pass->GetExact(), "an image behind a quad: not exact");
  }
}
}

int TestPeelingEnds(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      CheckQueryOfApplication(report, setup);
      CheckImage(report, setup);
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
