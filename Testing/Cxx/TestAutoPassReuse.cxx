// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Frames in which nothing has changed are reused, and only those: after each kind of change the
// picture is the one that is drawn without reuse.

#include "ReuseScene.h"
#include "TestRig.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkOITAutoPass.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTranslucentPass.h"

#include <cmath>
#include <cstring>
#include <functional>

VTK_MODULE_INIT(vtkRenderingFreeType); // for vtkTextActor

using namespace vtkOITTest;

namespace
{
constexpr int Width = 64;
constexpr int Height = 48;
constexpr Tolerance LastBits{ 1e-6, 1e-6 }; // of a layer composited over a float32 framebuffer

bool IsReused(vtkOITAutoPass* pass)
{
  return pass->GetSkipSummary().find("whole frame reused") != std::string::npos;
}

double FindLargestDifference(const Image& a, const Image& b)
{
  double largest = a.Pixels.size() == b.Pixels.size() ? 0.0 : HUGE_VAL;
  for (std::size_t i = 0; i < a.Pixels.size() && i < b.Pixels.size(); ++i)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      largest = std::max<double>(largest, std::abs(a.Pixels[i][channel] - b.Pixels[i][channel]));
    }
  }
  return largest;
}

/// Renders until a frame is reused; it has the same bits as the one before.
Image RenderStill(TestReport& report, ReuseScene& scene, const std::string& what)
{
  scene.Rig.Render();
  const Image second = scene.Rig.Render();
  const Image third = scene.Rig.Render();
  report.Check(IsReused(scene.Pass) && scene.Pass->GetNumberOfGeometryPasses() == 0,
    what + ": the third still frame is not reused");
  report.CompareBits(what + ", third still frame", third, second);
  return third;
}

Image RenderFresh(ReuseScene& scene)
{
  scene.Pass->ReuseFramesOff();
  Image image = scene.Rig.Render();
  scene.Pass->ReuseFramesOn();
  return image;
}

struct Change
{
  enum Kind
  {
    Seen,    // must be drawn anew
    Shown,   // the layer is reused, the picture is another one
    NotReady // not reused before the change either
  };
  std::string Name;
  std::function<void(ReuseScene&)> Do;
  Kind Is = Seen;
};

void CheckChange(TestReport& report, ReuseScene& scene, const Change& change)
{
  const Image before =
    change.Is == Change::NotReady ? scene.Rig.Render() : RenderStill(report, scene, change.Name);
  change.Do(scene);
  const Image after = scene.Rig.Render();
  const bool isReused = IsReused(scene.Pass);
  report.Check(isReused == (change.Is == Change::Shown),
    change.Name + (isReused ? ": is not seen" : ": the frame is not reused"));
  report.Check(
    FindLargestDifference(before, after) > 1e-3 || isReused, change.Name + ": changes nothing");
  report.Compare(change.Name, after, RenderFresh(scene), LastBits);
}

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
  return scene.Rig.Renderer->GetActiveCamera();
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
    { "viewport", [](ReuseScene& s) { s.Rig.Renderer->SetViewport(0.0, 0.1, 0.8, 1.0); } },
    { "window size", [](ReuseScene& s) { s.Rig.SetSize(Width + 10, Height - 6); } },
    { "another camera",
      [](ReuseScene& s)
      {
        vtkNew<vtkCamera> camera;
        camera->DeepCopy(GetCamera(s));
        camera->SetPosition(-0.5, 0.4, 6.5);
        s.Rig.Renderer->SetActiveCamera(camera);
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
    { "actor removed", [](ReuseScene& s) { s.Rig.Renderer->RemoveActor(s.SecondBall); } },
    { "actor added", [](ReuseScene& s) { s.Rig.Renderer->AddActor(s.SecondBall); } },
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
        s.Rig.Renderer->AddLight(light);
      } },
    { "lamp removed", [](ReuseScene& s) { s.Rig.Renderer->RemoveLight(s.Headlight); } },
    { "opaque prop moved", [](ReuseScene& s) { s.OpaqueBall->AddPosition(0.0, 0.0, 0.8); } },
    { "opaque prop recoloured",
      [](ReuseScene& s) { s.OpaqueBall->GetProperty()->SetColor(0.9, 0.9, 0.2); }, Change::Shown },
    { "background",
      [](ReuseScene& s) {
        s.Rig.SetBackground({ 0.8, 0.6, 0.4, 1.0 });
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
        s.Rig.Renderer->AddActor2D(text);
      },
      Change::Shown },
    { "text changed",
      [](ReuseScene& s)
      {
        vtkCollectionSimpleIterator it;
        vtkPropCollection* props = s.Rig.Renderer->GetViewProps();
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

void CheckPass(TestReport& report, const Setup& setup)
{
  TestRig rig(setup, Width, Height);
  ReuseScene scene(rig);
  rig.Render();
  for (const auto& change : GetPassChanges())
  {
    CheckChange(report, scene, change);
  }
  scene.Pass->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  // Half floats or floats: too little to be seen, but whoever asks for it must get it.
  for (const auto& change :
    std::vector<Change>{
      { "precision",
        [](ReuseScene& s)
        {
          s.Pass->SetFragmentPrecision(s.Pass->GetFragmentPrecision() == vtkOITPass::HALF
              ? vtkOITPass::FLOAT
              : vtkOITPass::HALF);
        } },
      { "threshold", [](ReuseScene& s) { s.Pass->SetTransmittanceThreshold(0.25); } },
      { "sorting", [](ReuseScene& s) { s.Pass->SkipSortingOff(); } },
      { "peels", [](ReuseScene& s) { s.Pass->SetMaximumNumberOfPeels(100); } },
    })
  {
    RenderStill(report, scene, change.Name);
    change.Do(scene);
    rig.Render();
    report.Check(!IsReused(scene.Pass), change.Name + ": is not seen");
  }
}

/// A uniform that an observer sets anew for each frame.
struct UniformSetter
{
  float Value = 0.1f;
  void Set(vtkObject*, unsigned long, void* data)
  {
    static_cast<vtkShaderProgram*>(data)->SetUniformf("red", this->Value);
  }
};

void CheckUniforms(TestReport& report, const Setup& setup)
{
  TestRig rig(setup, Width, Height);
  ReuseScene scene(rig);
  UniformSetter setter;
  scene.Ball->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].r = red;\n", false);
  scene.Ball->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Dec", true, "//VTK::Color::Dec\nuniform float red;\n", false);
  scene.BallMapper->AddObserver(vtkCommand::UpdateShaderEvent, &setter, &UniformSetter::Set);
  Image before = rig.Render();
  for (int frame = 0; frame < 5; ++frame)
  {
    setter.Value += 0.15f;
    const Image image = rig.Render();
    report.Check(!IsReused(scene.Pass), "a frame with a uniform of an observer is reused");
    report.Check(FindLargestDifference(before, image) > 0.01, "the uniform is not seen");
    before = image;
  }
}

/// The layer belongs to one renderer of one window.
void CheckRenderers(TestReport& report, const Setup& setup)
{
  TestRig rig(setup, Width, Height);
  ReuseScene scene(rig);
  rig.Render();
  RenderStill(report, scene, "one renderer");

  // The same props in a second renderer, by the same pass.
  vtkNew<vtkRenderer> second;
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(rig.Renderer->GetActiveCamera());
  second->SetActiveCamera(camera);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  rig.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  for (vtkActor* actor : { scene.Ball.Get(), scene.SecondBall.Get(), scene.Poster.Get() })
  {
    second->AddActor(actor);
  }
  rig.Window->AddRenderer(second);
  setup.Attach(second, rig.Pass);
  const Image first = rig.RenderWindow();
  for (int frame = 0; frame < 4; ++frame)
  {
    report.Compare("two renderers", rig.RenderWindow(), first, { 1.1 / 255.0, 1.1 / 255.0 });
  }
  camera->Azimuth(40.0);
  const Image turned = rig.RenderWindow();
  report.Check(FindLargestDifference(first, turned) > 0.01, "the second renderer is not redrawn");
  setup.Detach(second);
  rig.Window->RemoveRenderer(second);
  rig.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  const Image still = RenderStill(report, scene, "one renderer left");

  // Another window, with the camera and the props of the first.
  setup.Detach(rig.Renderer);
  {
    TestRig other(setup, Width, Height);
    setup.Attach(other.Renderer, rig.Pass);
    other.Renderer->SetActiveCamera(rig.Renderer->GetActiveCamera());
    for (vtkActor* actor : { scene.TableActor.Get(), scene.Poster.Get() })
    {
      other.Renderer->AddActor(actor);
    }
    other.Render();
    const Image second2 = other.Render();
    report.CompareBits("another window", other.Render(), second2);
    scene.Pass->ReuseFramesOff();
    report.Compare("another window, fresh", second2, other.Render(), LastBits);
    scene.Pass->ReuseFramesOn();
    setup.Detach(other.Renderer);
    other.Renderer->RemoveAllViewProps();
  }
  setup.Attach(rig.Renderer, rig.Pass);
  report.Compare("back in the first window", rig.Render(), still, LastBits);
  RenderStill(report, scene, "back in the first window");
}

void CheckNewContext(TestReport& report, const Setup& setup)
{
  TestRig rig(setup, Width, Height);
  ReuseScene scene(rig);
  rig.RenderWindow();
  rig.RenderWindow();
  rig.RenderWindow();
  const Image before = rig.RenderWindow();
  report.Check(IsReused(scene.Pass), "window: the third frame is not reused");
  rig.Window->Finalize();
  const Image after = rig.RenderWindow();
  report.Check(!IsReused(scene.Pass), "a layer of a context that is gone is reused");
  report.Compare("after Finalize()", after, before, { 1.1 / 255.0, 1.1 / 255.0 });
}
}

int TestAutoPassReuse(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](TestReport& report, const Setup& setup)
    {
      const bool isFirst = setup.FragmentStorage == Storage::Half && setup.Tier == "all extensions";
      TestRig rig(setup, Width, Height);
      ReuseScene scene(rig);
      rig.Render(); // makes default lookup tables, which is a change
      for (const auto& changes :
        { GetLightChanges(), GetViewChanges(), GetPropChanges(), GetDataChanges() })
      {
        for (const Change& change : changes)
        {
          CheckChange(report, scene, change);
          if (!isFirst)
          {
            break; // the rest does not depend on the tier
          }
        }
      }
      vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(2.0, 2.0); // VTK's
      CheckPass(report, setup);
      CheckUniforms(report, setup);
      CheckRenderers(report, setup);
      CheckNewContext(report, setup);
    });
}
