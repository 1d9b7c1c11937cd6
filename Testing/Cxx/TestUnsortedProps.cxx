// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Props made of parts, as representations of widgets and vtkAnnotatedCubeActor are, which do not
// hand on their property keys. Where they list their parts, these are sorted. Where they do not, or
// say that they have nothing translucent, they are blended in their place among the others, by the
// depths of boxes: that is not exact, but takes nothing away from the others, and where boxes lie
// apart the picture is right.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

using namespace vtkOITTest;

namespace
{
class Composite : public vtkProp
{
public:
  static Composite* New();
  vtkTypeMacro(Composite, vtkProp);

  double* GetBounds() override { return this->Drawn->GetBounds(); }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return this->Denies ? 0 : 1; }
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    return this->Drawn->RenderTranslucentPolygonalGeometry(viewport);
  }
  void GetActors(vtkPropCollection* actors) override
  {
    if (this->Lists)
    {
      actors->AddItem(this->Part);
    }
  }

  vtkSmartPointer<vtkActor> Part;
  vtkSmartPointer<vtkProp3D> Drawn; // the part, or an assembly of it
  bool Lists = false;
  bool Denies = false;

protected:
  Composite() = default;
  ~Composite() override = default;
};
vtkStandardNewMacro(Composite);

constexpr int Width = 16;
const Layer Near{ 0.25f, { 0.0f, 0.75f, 0.25f, 0.25f } };
const Layer Middle{ 0.5f, { 0.875f, 0.0f, 0.125f, 0.5f } };
const Layer Far{ 0.75f, { 0.25f, 0.125f, 1.0f, 0.75f } };

/// The middle layer is a part, in the left half, between two quads. `drawn`: the layers there, as
/// they are blended, nearest first.
void TestPart(Report& report, const Setup& setup, const std::string& what, bool lists, bool denies,
  bool assembles, std::vector<Layer> drawn)
{
  Rig rig(setup, Width, 12);
  vtkActor* part = rig.AddQuad(Middle, { 0.0, 0.0, Width / 2.0, 12.0 });
  vtkNew<Composite> composite;
  composite->Part = part;
  composite->Drawn = part;
  if (assembles)
  {
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(part);
    composite->Drawn = assembly;
  }
  composite->Lists = lists;
  composite->Denies = denies;
  rig.Renderer->RemoveViewProp(part);
  rig.AddQuad(Near);
  rig.Renderer->AddViewProp(composite);
  rig.AddQuad(Far);
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    drawn[i].Depth = 0.25f * static_cast<float>(i + 1); // as far as the reference can tell
  }
  const glm::dvec4 background = rig.GetBackground();
  const std::vector<Layer> beside{ Near, Far };
  const Tolerance tolerance =
    ReferenceCompositor::RoundingBound(drawn, background, setup.FragmentStorage);
  for (int frame = 0; frame < 3; ++frame)
  {
    report.Compare(
      what, rig.Render(),
      [&](int x, int)
      { return ReferenceCompositor::Composite(x < Width / 2 ? drawn : beside, background); },
      tolerance);
    report.Check(rig.Pass->GetExact() == lists, what + ": wrong promise");
  }
}

enum class Kind
{
  Sorted,
  NotListed,
  Denied
};

/// A quad over the whole viewport, or a prop that draws one.
vtkSmartPointer<vtkActor> AddProp(Rig& rig, const Layer& layer, Kind kind)
{
  vtkSmartPointer<vtkActor> quad = rig.AddQuad(layer);
  if (kind != Kind::Sorted)
  {
    rig.Renderer->RemoveViewProp(quad);
    vtkNew<Composite> composite;
    composite->Part = quad;
    composite->Drawn = quad;
    composite->Denies = kind == Kind::Denied;
    rig.Renderer->AddViewProp(composite);
  }
  return quad;
}

/// Stacks of layers of these kinds, nearest first, which are added in another order.
void TestPlaces(Report& report, const Setup& setup)
{
  constexpr Kind s = Kind::Sorted;
  constexpr Kind n = Kind::NotListed;
  constexpr Kind d = Kind::Denied;
  const std::vector<std::vector<Kind>> stacks{ { n, s, s }, { s, s, n }, { s, n, s, d, s },
    { s, n, n, s }, { n, s, s, d }, { n, d, n }, { s, s, n, s, s, s } };
  for (const std::vector<Kind>& stack : stacks)
  {
    Rig rig(setup, 8, 6);
    std::vector<Layer> layers;
    std::string what = "stack";
    for (std::size_t i = 0; i < stack.size(); ++i)
    {
      const auto part = static_cast<float>(i) / 8.0f;
      layers.push_back({ 0.125f + part, { part, 0.25f, 1.0f - part, 0.25f + 0.5f * part } });
      what += stack[i] == s ? " sorted" : stack[i] == n ? " not listed" : " denied";
    }
    for (const std::size_t i : { 3, 0, 5, 1, 4, 2 })
    {
      if (i < stack.size())
      {
        AddProp(rig, layers[i], stack[i]);
      }
    }
    for (int frame = 0; frame < 3; ++frame)
    {
      report.Compare(what, rig.Render(),
        Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
        ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
      report.Check(!rig.Pass->GetExact(), what + ": wrong promise");
    }
  }
}

/// One that moves through a stack of which nothing else changes.
void TestMoves(Report& report, const Setup& setup)
{
  Rig rig(setup, 8, 6);
  const std::vector<Layer> others{ { 0.25f, { 0.0f, 0.75f, 0.25f, 0.25f } },
    { 0.5f, { 0.25f, 0.125f, 1.0f, 0.5f } }, { 0.75f, { 0.875f, 0.0f, 0.125f, 0.75f } } };
  rig.AddStack(others);
  const Layer moving{ 0.125f, { 0.75f, 1.0f, 0.0f, 0.5f } };
  vtkSmartPointer<vtkActor> actor = AddProp(rig, moving, Kind::NotListed);
  for (const float depth : { 0.125f, 0.375f, 0.875f, 0.625f, 0.125f })
  {
    actor->SetPosition(0.0, 0.0, DepthToZ(depth) - DepthToZ(moving.Depth));
    std::vector<Layer> layers = others;
    layers.push_back({ depth, moving.Color });
    for (int frame = 0; frame < 3; ++frame)
    {
      report.Compare("moving, at depth " + std::to_string(depth), rig.Render(),
        Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
        ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
      report.Check(!rig.Pass->GetExact(), "moving: wrong promise");
    }
  }
}
}

int TestUnsortedProps(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      vtkObject::GlobalWarningDisplayOff(); // one warning for each is what is wanted
      TestPart(report, setup, "listed", true, false, false, { Near, Middle, Far });
      TestPart(report, setup, "listed, in an assembly", true, false, true, { Near, Middle, Far });
      TestPart(report, setup, "not listed", false, false, false, { Near, Middle, Far });
      TestPart(report, setup, "denied", false, true, false, { Near, Middle, Far });
      TestPlaces(report, setup);
      TestMoves(report, setup);
      vtkObject::GlobalWarningDisplayOn();
    });
}
