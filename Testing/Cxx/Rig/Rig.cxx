// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/Rig.h"

#include "Rig/GLMessages.h"
#include "Rig/GLObjects.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOITRendererHook.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

namespace vtkOITTest
{
namespace
{
bool KeepsWindow = false;
vtkSmartPointer<vtkRenderWindow> KeptWindow;

/// The window of an earlier rig, or a new one.
vtkSmartPointer<vtkRenderWindow> TakeWindow()
{
  vtkSmartPointer<vtkRenderWindow> window = KeptWindow;
  KeptWindow = nullptr;
  return window ? window : vtkSmartPointer<vtkRenderWindow>::New();
}

/// Whether no test has changed what the constructor of a rig leaves as it is.
bool IsAsNew(vtkRenderWindow* window)
{
  const int* scale = window->GetTileScale();
  return window->GetRenderers()->GetNumberOfItems() == 1 && window->GetNumberOfLayers() == 1 &&
    window->GetMultiSamples() == 0 && window->GetStencilCapable() == 0 && scale[0] == 1 &&
    scale[1] == 1 && !window->GetNeverRendered();
}
}

//------------------------------------------------------------------------------
void Rig::KeepWindow(bool keep)
{
  KeepsWindow = keep;
  KeptWindow = nullptr;
}

//------------------------------------------------------------------------------
Rig::Rig(const Setup& setup, int width, int height)
  : Pass(setup.CreatePass())
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Window(TakeWindow())
  , TheSetup(setup)
  , Width(width)
  , Height(height)
  , TargetColorType(VTK_FLOAT)
  , TargetDepthFormat(vtkTextureObject::Float32)
  , Camera(vtkSmartPointer<vtkCamera>::New())
{
  this->Camera->ParallelProjectionOn();
  this->Camera->SetParallelScale(1.0);
  this->Camera->SetPosition(0.0, 0.0, 2.0);
  this->Camera->SetFocalPoint(0.0, 0.0, 0.0);
  this->Camera->SetViewUp(0.0, 1.0, 0.0);
  this->Camera->SetClippingRange(1.0, 3.0);
  this->Renderer->SetActiveCamera(this->Camera);
  this->Renderer->AddObserver(vtkCommand::StartEvent, this, &Rig::BindTarget);
  this->Renderer->AddObserver(vtkCommand::EndEvent, this, &Rig::ReadTarget);
  this->SetBackground(glm::dvec4(0.2, 0.4, 0.6, 0.4));

  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetAlphaBitPlanes(1);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  setup.Attach(this->Renderer, this->Pass);
}

//------------------------------------------------------------------------------
Rig::~Rig()
{
  if (this->Target)
  {
    this->Window->MakeCurrent();
    this->Target->ReleaseGraphicsResources(this->Window);
  }
  if (KeepsWindow && IsAsNew(this->Window))
  {
    vtkOITRendererHook::Uninstall(this->Renderer);
    if (vtkRenderPass* pass = this->Renderer->GetPass())
    {
      pass->ReleaseGraphicsResources(this->Window);
      this->Renderer->SetPass(nullptr);
    }
    this->Window->RemoveRenderer(this->Renderer);
    KeptWindow = this->Window;
  }
}

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* Rig::GetGLWindow()
{
  return vtkOpenGLRenderWindow::SafeDownCast(this->Window);
}

//------------------------------------------------------------------------------
void Rig::SetSize(int width, int height)
{
  this->Width = width;
  this->Height = height;
  this->Window->SetSize(width, height);
}

//------------------------------------------------------------------------------
void Rig::SetBackground(const glm::dvec4& color)
{
  this->Renderer->SetBackground(color.r, color.g, color.b);
  this->Renderer->SetBackgroundAlpha(color.a);
}

//------------------------------------------------------------------------------
glm::dvec4 Rig::GetBackground() const
{
  const double* color = this->Renderer->GetBackground();
  return { color[0], color[1], color[2], this->Renderer->GetBackgroundAlpha() };
}

//------------------------------------------------------------------------------
void Rig::SetTargetFormat(int colorType, int depthFormat)
{
  this->TargetColorType = colorType;
  this->TargetDepthFormat = depthFormat;
  if (this->Target)
  {
    this->Window->MakeCurrent();
    this->Target->ReleaseGraphicsResources(this->Window);
    this->Target = nullptr;
  }
}

//------------------------------------------------------------------------------
PixelRectangle Rig::GetFullRectangle() const
{
  return { 0.0, 0.0, double(this->Width), double(this->Height) };
}

//------------------------------------------------------------------------------
glm::dvec3 Rig::ToWorld(double x, double y, double depth) const
{
  // The parallel scale is half the height of the viewport in world units.
  return { (2.0 * x - this->Width) / this->Height, (2.0 * y - this->Height) / this->Height,
    DepthToZ(depth) };
}

//------------------------------------------------------------------------------
vtkActor* Rig::AddPolyData(vtkPolyData* polydata, const glm::vec4& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polydata);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  actor->GetProperty()->SetOpacity(color.a);
  this->Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* Rig::AddQuadOf(const std::vector<glm::dvec3>& corners, const glm::vec4& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell(4);
  for (const glm::dvec3& corner : corners)
  {
    quads->InsertCellPoint(points->InsertNextPoint(corner.x, corner.y, corner.z));
  }
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(quads);
  return this->AddPolyData(polydata, color);
}

//------------------------------------------------------------------------------
vtkActor* Rig::AddQuad(const Layer& layer, const PixelRectangle& rectangle)
{
  return this->AddQuadOf({ this->ToWorld(rectangle.X0, rectangle.Y0, layer.Depth),
                           this->ToWorld(rectangle.X1, rectangle.Y0, layer.Depth),
                           this->ToWorld(rectangle.X1, rectangle.Y1, layer.Depth),
                           this->ToWorld(rectangle.X0, rectangle.Y1, layer.Depth) },
    layer.Color);
}

//------------------------------------------------------------------------------
vtkActor* Rig::AddRamp(double leftDepth, double rightDepth, const glm::vec4& color)
{
  return this->AddQuadOf(
    { this->ToWorld(0, 0, leftDepth), this->ToWorld(this->Width, 0, rightDepth),
      this->ToWorld(this->Width, this->Height, rightDepth),
      this->ToWorld(0, this->Height, leftDepth) },
    color);
}

//------------------------------------------------------------------------------
vtkActor* Rig::AddQuad(const Layer& layer)
{
  return this->AddQuad(layer, this->GetFullRectangle());
}

//------------------------------------------------------------------------------
void Rig::AddStack(const std::vector<Layer>& layers)
{
  for (const Layer& layer : layers)
  {
    this->AddQuad(layer)->ForceTranslucentOn(); // also where the opacity is 1
  }
}

//------------------------------------------------------------------------------
vtkActor* Rig::AddEqualLayers(const std::vector<float>& depths, const glm::vec4& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (const float depth : depths)
  {
    quads->InsertNextCell(4);
    for (const glm::dvec3& point :
      { this->ToWorld(0, 0, depth), this->ToWorld(this->Width, 0, depth),
        this->ToWorld(this->Width, this->Height, depth), this->ToWorld(0, this->Height, depth) })
    {
      quads->InsertCellPoint(points->InsertNextPoint(point.x, point.y, point.z));
    }
  }
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(quads);
  vtkActor* actor = this->AddPolyData(polydata, color);
  actor->ForceTranslucentOn();
  return actor;
}

//------------------------------------------------------------------------------
void Rig::RemoveProps()
{
  this->Renderer->RemoveAllViewProps();
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkActor>> Rig::GetActors() const
{
  vtkActorCollection* all = this->Renderer->GetActors();
  std::vector<vtkSmartPointer<vtkActor>> actors;
  all->InitTraversal();
  while (vtkActor* actor = all->GetNextActor())
  {
    actors.emplace_back(actor);
  }
  return actors;
}

//------------------------------------------------------------------------------
void Rig::SetDrawOrder(const std::vector<vtkSmartPointer<vtkActor>>& actors)
{
  vtkPropCollection* props = this->Renderer->GetViewProps();
  props->RemoveAllItems(); // vtkRenderer's own methods would release the shaders
  for (vtkActor* actor : actors)
  {
    props->AddItem(actor);
  }
}

//------------------------------------------------------------------------------
void Rig::BindTarget(vtkObject*, unsigned long, void*)
{
  GLMessages::Watch(); // each time: the context may be a new one
  if (!this->UseTarget)
  {
    return;
  }
  vtkOpenGLRenderWindow* window = this->GetGLWindow();
  window->GetState()->PushFramebufferBindings();
  if (this->Target)
  {
    const int* size = this->Target->GetLastSize();
    if (size[0] != this->Width || size[1] != this->Height)
    {
      this->Target->ReleaseGraphicsResources(window);
      this->Target = nullptr;
    }
  }
  if (!this->Target)
  {
    this->Target = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Target->SetContext(window);
    vtkNew<vtkTextureObject> color;
    color->SetContext(window);
    color->Allocate2D(this->Width, this->Height, 4, this->TargetColorType);
    vtkNew<vtkTextureObject> depth;
    depth->SetContext(window);
    depth->AllocateDepth(this->Width, this->Height, this->TargetDepthFormat);
    this->Target->Bind();
    this->Target->AddColorAttachment(0, color);
    this->Target->AddDepthAttachment(depth);
  }
  this->Target->Bind();
  this->Target->ActivateDrawBuffer(0);
  this->Target->ActivateReadBuffer(0);
}

//------------------------------------------------------------------------------
void Rig::ReadTarget(vtkObject*, unsigned long, void*)
{
  if (!this->UseTarget)
  {
    return;
  }
  // Bound again, in case what was rendered left another framebuffer bound.
  this->Target->Bind();
  this->Target->ActivateReadBuffer(0);
  const std::size_t size = static_cast<std::size_t>(this->Width) * this->Height;
  this->Color = Image{ this->Width, this->Height, std::vector<glm::vec4>(size) };
  glReadPixels(0, 0, this->Width, this->Height, GL_RGBA, GL_FLOAT, this->Color.Pixels.data());
  std::vector<float> depth(size);
  glReadPixels(0, 0, this->Width, this->Height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  this->Depth = Image{ this->Width, this->Height, {} };
  for (const float value : depth)
  {
    this->Depth.Pixels.emplace_back(value);
  }
  this->GetGLWindow()->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
Image Rig::Render()
{
  if (this->TheSetup.IsContender)
  {
    return this->RenderWindowWithDepth();
  }
  this->UseTarget = true;
  this->Color = Image();
  this->Window->Render();
  this->UseTarget = false;
  return this->Color;
}

//------------------------------------------------------------------------------
Image Rig::RenderWindowWithDepth()
{
  Image image = this->RenderWindow();
  std::vector<float> depth(image.Pixels.size());
  this->Window->GetZbufferData(0, 0, this->Width - 1, this->Height - 1, depth.data());
  this->Depth = Image{ this->Width, this->Height, {} };
  for (const float value : depth)
  {
    this->Depth.Pixels.emplace_back(value);
  }
  return image;
}

//------------------------------------------------------------------------------
Image Rig::RenderWindow()
{
  this->Window->Render();
  vtkNew<vtkUnsignedCharArray> bytes;
  this->Window->GetRGBACharPixelData(0, 0, this->Width - 1, this->Height - 1, 0, bytes);
  Image image{ this->Width, this->Height, {} };
  for (vtkIdType i = 0; i < vtkIdType(this->Width) * this->Height; ++i)
  {
    const unsigned char* pixel = bytes->GetPointer(4 * i);
    image.Pixels.emplace_back(
      pixel[0] / 255.0f, pixel[1] / 255.0f, pixel[2] / 255.0f, pixel[3] / 255.0f);
  }
  return image;
}

//------------------------------------------------------------------------------
Report::Expected Everywhere(const glm::dvec4& color)
{
  return [color](int, int) { return color; };
}
}
