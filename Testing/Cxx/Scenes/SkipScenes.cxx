// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/SkipScenes.h"

#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"

#include <cmath>

namespace vtkOITTest
{
namespace
{
void AddTexture(vtkActor* actor)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 8; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
      static_cast<unsigned char>(30 * i + 20);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOff();
  actor->SetTexture(texture);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const float x : { 0.0f, 1.0f, 1.0f, 0.0f })
  {
    coordinates->InsertNextTuple2(x, 0.5);
  }
  vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))
    ->GetPointData()
    ->SetTCoords(coordinates);
}

/// Selects the first cell; false where VTK's mappers know no selections.
///@{
template <typename Mapper>
auto SelectCell(Mapper* mapper, int) -> decltype(mapper->GetSelection() != nullptr)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->InsertNextValue(0);
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(vtkSelectionNode::CELL);
  node->SetSelectionList(ids);
  vtkNew<vtkSelection> selection;
  selection->AddNode(node);
  mapper->SetSelection(selection);
  return true;
}
template <typename Mapper>
bool SelectCell(Mapper*, long)
{
  return false;
}
///@}

/// Two quads that have a known order.
std::vector<vtkActor*> AddTwoQuads(Rig& rig)
{
  return { rig.AddQuad({ 0.3f, Red }, { 4, 4, 40, 40 }),
    rig.AddQuad({ 0.6f, Green }, { 20, 10, 60, 44 }) };
}
}

std::vector<SkipScene> GetInvisibleScenes()
{
  const auto with = [](const std::function<void(Rig&, vtkActor*)>& change)
  { return [change](Rig& rig) { change(rig, AddTwoQuads(rig)[0]); }; };
  return {
    { "opacity 0", with([](Rig&, vtkActor* a) { a->GetProperty()->SetOpacity(0.0); }), 1, 1, 0, 1 },
    { "opacity 0 of the front only",
      with(
        [](Rig&, vtkActor* a)
        {
          a->GetProperty()->SetOpacity(0.0);
          vtkNew<vtkProperty> inside;
          inside->SetOpacity(0.5);
          a->SetBackfaceProperty(inside);
          a->RotateY(180.0);
        }),
      0, 2, 0, 1 },
    { "opacity 0 with a selected cell, which has another",
      with(
        [](Rig&, vtkActor* a)
        {
          if (SelectCell(a->GetMapper(), 0))
          {
            a->GetProperty()->SetOpacity(0.0);
          }
        }),
      0, Any, Any },
    { "empty data",
      with([](Rig&, vtkActor* a)
        { vtkPolyData::SafeDownCast(a->GetMapper()->GetInputDataObject(0, 0))->Initialize(); }),
      Any, 1, 0, 1 },
    { "outside of the view", with([](Rig&, vtkActor* a) { a->SetPosition(5.0, 0.0, 0.0); }), Any, 1,
      0, 1 }, // mostly VTK leaves it out
    { "before the near plane", with([](Rig&, vtkActor* a) { a->SetPosition(0.0, 0.0, 0.7); }), 1, 1,
      0, 1 },
    { "behind the far plane", with([](Rig&, vtkActor* a) { a->SetPosition(0.0, 0.0, -2.0); }), 1, 1,
      0, 1 },
    { "not visible", with([](Rig&, vtkActor* a) { a->VisibilityOff(); }), 0, 1, 0, 1 },
    { "all of opacity 0",
      with(
        [](Rig& rig, vtkActor* a)
        {
          a->GetProperty()->SetOpacity(0.0);
          rig.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(0.0);
        }),
      2, 0, 0, 0 },
    { "behind the camera",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 0.0, 0.0, 5.0 });
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddSphere(rig, Green, { 0.0, 0.0, 9.0 }, 0.8);
      },
      Any, Any, Any },
    { "beside the near plane, partly behind the camera",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 0.0, 0.0, 5.0 });
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddBox(rig, Green, { -0.4, -0.4, 1.0 }, { -0.2, 0.4, 7.0 });
      },
      0, 0, 2 },
  };
}

std::vector<SkipScene> GetFlatScenes()
{
  const auto with = [](const std::function<void(vtkActor*)>& change)
  { return [change](Rig& rig) { change(AddTwoQuads(rig)[0]); }; };
  return {
    { "disjoint quads",
      [](Rig& rig)
      {
        rig.AddQuad({ 0.5f, Red }, { 2, 2, 20, 40 });
        rig.AddQuad({ 0.5f, Green }, { 30, 2, 60, 20 });
        rig.AddQuad({ 0.5f, Blue }, { 30, 30, 60, 44 });
      },
      0, 3, 0, 1, 1 },
    { "64 shuffled planes",
      [](Rig& rig)
      {
        for (const Layer& layer : Random(12).Layers(64))
        {
          rig.AddQuad(layer);
        }
      },
      0, 64, 0, 1, 64 },
    { "two quads", with([](vtkActor*) {}), 0, 2, 0, 1 },
    { "texture", with(AddTexture), 0, 2, 0, 1 },
    { "mirrored quad", with([](vtkActor* a) { a->SetScale(-1.0, 1.0, 1.0); }), 0, 2, 0, 1 },
    { "crossing quads",
      [](Rig& rig)
      {
        rig.AddRamp(0.2, 0.7, Red);
        rig.AddRamp(0.8, 0.3, Green);
      },
      0, 0, 2 },
    { "tilted quads, one behind the other",
      [](Rig& rig)
      {
        rig.AddRamp(0.1, 0.4, Red);
        rig.AddRamp(0.9, 0.5, Green);
      },
      0, 2, 0, 1 },
    { "wireframe", with([](vtkActor* a) { a->GetProperty()->SetRepresentationToWireframe(); }), 0,
      0, 2 },
    { "edges", with([](vtkActor* a) { a->GetProperty()->EdgeVisibilityOn(); }), 0, 0, 2 },
    { "points", with([](vtkActor* a) { a->GetProperty()->SetRepresentationToPoints(); }), 0, 0, 2 },
    { "equal depths",
      [](Rig& rig)
      {
        rig.AddQuad({ 0.5f, Red }, { 4, 4, 40, 40 });
        rig.AddQuad({ 0.5f, Green }, { 20, 10, 60, 44 });
      },
      0, 0, 2 },
    { "the same actor twice",
      [](Rig& rig)
      {
        vtkActor* actor = AddTwoQuads(rig)[0];
        vtkNew<vtkActor> copy;
        copy->ShallowCopy(actor);
        rig.Renderer->AddActor(copy);
      },
      0, 0, 3 },
    { "polygon offset",
      [](Rig& rig)
      {
        AddTwoQuads(rig);
        vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
      },
      0, 0, 2 },
    { "clipped quads",
      [](Rig& rig)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1.0, 0.7, 0.0);
        plane->SetOrigin(0.0123, 0.0, 0.0); // through no centre of a pixel
        for (vtkActor* actor : AddTwoQuads(rig))
        {
          actor->GetMapper()->AddClippingPlane(plane);
        }
      },
      0, 2, 0, 1 },
    { "quads and a sphere elsewhere on the screen",
      [](Rig& rig)
      {
        rig.AddQuad({ 0.3f, Red }, { 2, 4, 24, 40 });
        rig.AddQuad({ 0.6f, Green }, { 8, 10, 28, 44 });
        AddSphere(rig, Blue, { 0.7, 0.2, 0.0 }, 0.3);
        AddSphere(rig, Red, { 0.8, -0.2, 0.0 }, 0.3);
      },
      0, 2, 2 },
  };
}

//------------------------------------------------------------------------------
std::vector<SkipScene> GetPartialScenes()
{
  // Around depths 0.3 and 0.7 there is room for others.
  const auto addPlanes = [](Rig& rig)
  {
    for (int i = 0; i < 60; ++i)
    {
      const double depth = 0.02 + 0.96 * ((i * 23) % 60) / 59.0;
      if (std::abs(depth - 0.3) > 0.03 && std::abs(depth - 0.7) > 0.03)
      {
        rig.AddQuad({ static_cast<float>(depth), i % 2 == 0 ? Red : Blue });
      }
    }
  };
  const auto addCrossing = [](Rig& rig, double depth)
  {
    rig.AddRamp(depth - 0.02, depth + 0.02, Green);
    rig.AddRamp(depth + 0.02, depth - 0.02, Blue);
  };
  const auto addTwoLayers = [](Rig& rig, float depth) {
    return rig.AddEqualLayers({ depth + 0.01f, depth - 0.01f }, Green);
  };
  return {
    { "planes, and two that cross",
      [=](Rig& rig)
      {
        addCrossing(rig, 0.3);
        addPlanes(rig);
      },
      0, 52, 2, Any, 54 },
    { "planes, and two pairs that cross",
      [=](Rig& rig)
      {
        addCrossing(rig, 0.7);
        addPlanes(rig);
        addCrossing(rig, 0.3);
      },
      0, 52, 4, Any, 56 },
    { "planes, and a mesh of two layers",
      [=](Rig& rig)
      {
        addTwoLayers(rig, 0.7f);
        addPlanes(rig);
      },
      0, 52, 1, Any, 54 },
    { "planes, and meshes of two layers that share depths with two that cross",
      [=](Rig& rig)
      {
        addTwoLayers(rig, 0.3f);
        addPlanes(rig);
        addCrossing(rig, 0.3);
      },
      0, 52, 3, Any, 56 },
    { "planes, and a pair that crosses all of them",
      [=](Rig& rig)
      {
        addPlanes(rig);
        rig.AddRamp(0.0, 1.0, Green);
        rig.AddRamp(1.0, 0.0, Blue);
      },
      0, 0, 54, Any, 54 },
    { "planes, and lines",
      [=](Rig& rig)
      {
        addPlanes(rig);
        addTwoLayers(rig, 0.3f)->GetProperty()->EdgeVisibilityOn();
      },
      0, 0, 53, Any, 56 },
  };
}
}
