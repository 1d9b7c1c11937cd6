// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/ReuseChanges.h"

#include "Rig/Rig.h"
#include "Scenes/ReuseScene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOITAutoPass.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTranslucentPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>

namespace vtkOITTest
{
namespace
{
/// Moves one point in place.
void MovePoint(vtkPolyData* mesh, vtkIdType id)
{
  auto* points = vtkFloatArray::SafeDownCast(mesh->GetPoints()->GetData());
  points->SetComponent(id, 0, points->GetComponent(id, 0) - 0.2);
}

/// A delegate that leaves out its last prop.
class OtherDelegate : public vtkTranslucentPass
{
public:
  static OtherDelegate* New();
  vtkTypeMacro(OtherDelegate, vtkTranslucentPass);
  int Left = 0; // props that are left out

  void Render(const vtkRenderState* state) override
  {
    vtkRenderState fewer(state->GetRenderer());
    fewer.SetFrameBuffer(state->GetFrameBuffer());
    fewer.SetPropArrayAndCount(
      state->GetPropArray(), std::max(0, state->GetPropArrayCount() - this->Left));
    this->Superclass::Render(&fewer);
  }

protected:
  OtherDelegate() = default;
  ~OtherDelegate() override = default;
};
vtkStandardNewMacro(OtherDelegate);

vtkCamera* GetCamera(ReuseScene& scene)
{
  return scene.TheRig.Renderer->GetActiveCamera();
}
}

std::vector<Change> GetViewChanges()
{
  return {
    { "camera position", [](ReuseScene& s) { GetCamera(s)->SetPosition(0.5, 0.5, 6.0); } },
    { "view angle", [](ReuseScene& s) { GetCamera(s)->SetViewAngle(25.0); } },
    { "clipping range", [](ReuseScene& s) { GetCamera(s)->SetClippingRange(5.5, 12.0); } },
    { "roll", [](ReuseScene& s) { GetCamera(s)->Roll(20.0); } },
    { "window centre", [](ReuseScene& s) { GetCamera(s)->SetWindowCenter(0.1, 0.0); } },
    { "distance, which lights of the camera follow",
      [](ReuseScene& s) { GetCamera(s)->SetDistance(3.0); } },
    { "model transform",
      [](ReuseScene& s)
      {
        vtkNew<vtkMatrix4x4> matrix;
        matrix->SetElement(0, 3, 0.2);
        GetCamera(s)->SetModelTransformMatrix(matrix);
      } },
    { "parallel projection",
      [](ReuseScene& s)
      {
        GetCamera(s)->ParallelProjectionOn();
        GetCamera(s)->SetParallelScale(1.6);
      } },
    { "parallel scale", [](ReuseScene& s) { GetCamera(s)->SetParallelScale(1.2); } },
    { "back to perspective", [](ReuseScene& s) { GetCamera(s)->ParallelProjectionOff(); } },
    { "viewport", [](ReuseScene& s) { s.TheRig.Renderer->SetViewport(0.0, 0.1, 0.8, 1.0); } },
    { "window size",
      [](ReuseScene& s) { s.TheRig.SetSize(s.TheRig.GetWidth() + 10, s.TheRig.GetHeight() - 6); } },
    { "another camera",
      [](ReuseScene& s)
      {
        vtkNew<vtkCamera> camera;
        camera->DeepCopy(GetCamera(s));
        camera->SetPosition(-0.5, 0.4, 6.5);
        s.TheRig.Renderer->SetActiveCamera(camera);
      } },
  };
}

std::vector<Change> GetPropChanges()
{
  return {
    { "position", [](ReuseScene& s) { s.Ball->AddPosition(0.1, 0.0, 0.0); } },
    { "orientation", [](ReuseScene& s) { s.Poster->RotateZ(20.0); } },
    { "user matrix",
      [](ReuseScene& s)
      {
        vtkNew<vtkMatrix4x4> matrix;
        matrix->SetElement(1, 3, 0.1);
        s.Ball->SetUserMatrix(matrix);
      } },
    { "element of the user matrix",
      [](ReuseScene& s) { s.Ball->GetUserMatrix()->SetElement(1, 3, -0.1); } },
    { "user transform",
      [](ReuseScene& s)
      {
        vtkNew<vtkTransform> transform;
        s.TableActor->SetUserTransform(transform);
        transform->Translate(0.0, -0.2, 0.0);
      } },
    { "user transform turned",
      [](ReuseScene& s)
      { vtkTransform::SafeDownCast(s.TableActor->GetUserTransform())->RotateZ(30.0); } },
    { "colour", [](ReuseScene& s) { s.Ball->GetProperty()->SetColor(0.1, 0.2, 0.9); } },
    { "opacity", [](ReuseScene& s) { s.Ball->GetProperty()->SetOpacity(0.7); } },
    { "specular", [](ReuseScene& s) { s.Ball->GetProperty()->SetSpecular(0.9); } },
    { "shading", [](ReuseScene& s) { s.Ball->GetProperty()->SetInterpolationToFlat(); } },
    { "lighting", [](ReuseScene& s) { s.Ball->GetProperty()->LightingOff(); } },
    { "representation",
      [](ReuseScene& s) { s.Ball->GetProperty()->SetRepresentationToWireframe(); } },
    { "line width", [](ReuseScene& s) { s.Ball->GetProperty()->SetLineWidth(3.0); } },
    { "back to the surface",
      [](ReuseScene& s) { s.Ball->GetProperty()->SetRepresentationToSurface(); } },
    { "edges", [](ReuseScene& s) { s.Ball->GetProperty()->EdgeVisibilityOn(); } },
    { "culling", [](ReuseScene& s) { s.SecondBall->GetProperty()->FrontfaceCullingOn(); } },
    { "another property",
      [](ReuseScene& s)
      {
        vtkNew<vtkProperty> property;
        property->SetOpacity(0.6);
        s.Ball->SetProperty(property);
      } },
    { "culling off", [](ReuseScene& s) { s.SecondBall->GetProperty()->FrontfaceCullingOff(); } },
    { "colour of back faces",
      [](ReuseScene& s) { s.SecondBall->GetBackfaceProperty()->SetColor(0.1, 0.1, 0.9); } },
    { "actor hidden", [](ReuseScene& s) { s.SecondBall->VisibilityOff(); } },
    { "actor shown", [](ReuseScene& s) { s.SecondBall->VisibilityOn(); } },
    { "actor removed", [](ReuseScene& s) { s.TheRig.Renderer->RemoveActor(s.SecondBall); } },
    { "actor added", [](ReuseScene& s) { s.TheRig.Renderer->AddActor(s.SecondBall); } },
    { "actor made opaque",
      [](ReuseScene& s)
      {
        s.Poster->ForceTranslucentOff();
        s.Poster->ForceOpaqueOn();
      } },
    { "actor made translucent",
      [](ReuseScene& s)
      {
        s.Poster->ForceOpaqueOff();
        s.Poster->ForceTranslucentOn();
      } },
  };
}

std::vector<Change> GetDataChanges()
{
  return {
    { "source", [](ReuseScene& s) { s.BallSource->SetRadius(0.5); } },
    { "resolution of the source", [](ReuseScene& s) { s.BallSource->SetThetaResolution(5); } },
    { "other points",
      [](ReuseScene& s)
      {
        vtkNew<vtkPoints> points;
        points->DeepCopy(s.Table->GetPoints());
        points->SetPoint(0, -1.0, -0.7, 0.0);
        s.Table->SetPoints(points);
      } },
    { "points in place, points modified",
      [](ReuseScene& s)
      {
        MovePoint(s.Table, 3);
        s.Table->GetPoints()->Modified();
      } },
    { "points in place, array modified",
      [](ReuseScene& s)
      {
        MovePoint(s.Table, 6);
        s.Table->GetPoints()->GetData()->Modified();
      } },
    { "cell data",
      [](ReuseScene& s)
      {
        s.TableValues->SetValue(0, 0.9f);
        s.TableValues->Modified();
      } },
    { "other cells",
      [](ReuseScene& s)
      {
        vtkNew<vtkCellArray> cells;
        cells->InsertNextCell({ 0, 1, 4, 3 });
        s.Table->SetPolys(cells);
      } },
    { "entry of the lookup table",
      [](ReuseScene& s) { s.Colors->SetTableValue(3, 0.1, 0.1, 0.9, 0.8); } },
    { "table in place",
      [](ReuseScene& s)
      {
        s.Colors->GetTable()->SetTuple4(3, 250, 20, 20, 60);
        s.Colors->Modified();
      } },
    { "scalar range", [](ReuseScene& s) { s.TableMapper->SetScalarRange(0.0, 4.0); } },
    { "another lookup table",
      [](ReuseScene& s)
      {
        vtkNew<vtkLookupTable> table;
        table->SetAlpha(0.5);
        table->Build();
        s.TableMapper->SetLookupTable(table);
      } },
    { "scalars off", [](ReuseScene& s) { s.TableMapper->ScalarVisibilityOff(); } },
    { "texture image",
      [](ReuseScene& s)
      {
        std::memset(s.TextureImage->GetScalarPointer(), 130, 64);
        s.TextureImage->Modified();
      } },
    { "texels in place, array modified",
      [](ReuseScene& s)
      {
        std::memset(s.TextureImage->GetScalarPointer(), 200, 32);
        s.TextureImage->GetPointData()->GetScalars()->Modified();
      } },
    { "interpolation of texels", [](ReuseScene& s) { s.Texture->InterpolateOn(); } },
    { "texture by a table",
      [](ReuseScene& s)
      {
        vtkNew<vtkImageData> image;
        image->SetDimensions(2, 2, 1);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
        std::memset(image->GetScalarPointer(), 100, 4);
        vtkNew<vtkLookupTable> table;
        table->SetRange(0, 255);
        table->SetNumberOfTableValues(4);
        table->Build();
        s.Texture->SetInputData(image);
        s.Texture->SetColorModeToMapScalars();
        s.Texture->SetLookupTable(table);
      } },
    { "table of the texture",
      [](ReuseScene& s)
      {
        auto* table = vtkLookupTable::SafeDownCast(s.Texture->GetLookupTable());
        for (int i = 0; i < 4; ++i)
        {
          table->SetTableValue(i, 0.9, 0.1, 0.2, 0.5);
        }
      } },
    { "clipping plane", [](ReuseScene& s) { s.ClippingPlane->SetOrigin(0.3, 0.0, 0.0); } },
    { "clipping plane turned", [](ReuseScene& s) { s.ClippingPlane->SetNormal(0.2, 1.0, 0.0); } },
    { "no clipping plane",
      [](ReuseScene& s) { s.Poster->GetMapper()->RemoveAllClippingPlanes(); } },
    { "no texture", [](ReuseScene& s) { s.Poster->SetTexture(nullptr); } },
    { "coincident topology",
      [](ReuseScene&)
      {
        vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
        vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(0.0, 2e6);
      } },
    { "polygon offset",
      [](ReuseScene& s)
      {
        s.OpaqueBall->VisibilityOn();
        vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(0.0, -8e6);
      } },
    { "offset of one mapper",
      [](ReuseScene& s)
      { s.BallMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 1.6e7); } },
    { "no coincident topology",
      [](ReuseScene&) { vtkMapper::SetResolveCoincidentTopologyToOff(); } },
  };
}

std::vector<Change> GetLightChanges()
{
  return {
    { "lamp moved", [](ReuseScene& s) { s.Lamp->SetPosition(-3.0, 4.0, 2.0); } },
    { "colour of the lamp", [](ReuseScene& s) { s.Lamp->SetDiffuseColor(1.0, 0.3, 0.3); } },
    { "lamp off", [](ReuseScene& s) { s.Lamp->SwitchOff(); } },
    { "lamp of the camera moved",
      [](ReuseScene& s) { s.CameraLamp->SetPosition(-0.5, 0.2, 1.0); } },
    { "its cone", [](ReuseScene& s) { s.CameraLamp->SetConeAngle(25.0); } },
    { "headlight dimmed", [](ReuseScene& s) { s.Headlight->SetIntensity(0.9); } },
    { "headlight with a cone",
      [](ReuseScene& s)
      {
        s.Headlight->SetConeAngle(9.0);
        s.Headlight->PositionalOn();
      } },
    { "cone of the headlight", [](ReuseScene& s) { s.Headlight->SetConeAngle(5.0); } },
    { "exponent of the headlight", [](ReuseScene& s) { s.Headlight->SetExponent(40.0); } },
    { "attenuation of the headlight",
      [](ReuseScene& s) { s.Headlight->SetAttenuationValues(0.2, 0.0, 0.0); } },
    { "light added",
      [](ReuseScene& s)
      {
        vtkNew<vtkLight> light;
        light->SetPosition(0.0, -5.0, 1.0);
        s.TheRig.Renderer->AddLight(light);
      } },
    { "lamp removed", [](ReuseScene& s) { s.TheRig.Renderer->RemoveLight(s.Headlight); } },
    { "opaque prop moved", [](ReuseScene& s) { s.OpaqueBall->AddPosition(0.0, 0.0, 0.8); } },
    { "opaque prop recoloured",
      [](ReuseScene& s) { s.OpaqueBall->GetProperty()->SetColor(0.9, 0.9, 0.2); }, Change::Shown },
    { "background",
      [](ReuseScene& s) {
        s.TheRig.SetBackground({ 0.8, 0.6, 0.4, 1.0 });
      },
      Change::Shown },
    { "opaque prop removed", [](ReuseScene& s) { s.OpaqueBall->VisibilityOff(); } },
    { "text added",
      [](ReuseScene& s)
      {
        vtkNew<vtkTextActor> text;
        text->SetInput("text");
        text->SetPosition(2, 2);
        text->GetTextProperty()->SetColor(1.0, 0.0, 0.0);
        s.TheRig.Renderer->AddViewProp(text);
      },
      Change::Shown },
    { "text changed",
      [](ReuseScene& s)
      {
        vtkCollectionSimpleIterator it;
        vtkPropCollection* props = s.TheRig.Renderer->GetViewProps();
        props->InitTraversal(it);
        while (vtkProp* prop = props->GetNextProp(it))
        {
          if (auto* text = vtkTextActor::SafeDownCast(prop))
          {
            text->SetInput("another");
          }
        }
      },
      Change::Shown },
  };
}

std::vector<Change> GetPassChanges()
{
  return {
    { "delegate",
      [](ReuseScene& s)
      {
        vtkNew<OtherDelegate> delegate;
        delegate->Left = 1;
        s.Pass->SetTranslucentPass(delegate);
      } },
    { "property of the delegate",
      [](ReuseScene& s) { OtherDelegate::SafeDownCast(s.Pass->GetTranslucentPass())->Left = 0; },
      Change::NotReady },
  };
}
}
