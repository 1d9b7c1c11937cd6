// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITOSMesaRenderWindow.h"

#include "Private/vtkOITOSMesaContext.h"
#include "Private/vtkOITOSMesaLiveWindows.h"
#include "Private/vtkOITOSMesaRedirection.h"

#include "vtkCollection.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtk_glew.h"

#include <algorithm>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkOITOSMesaRenderWindow);

class vtkOITOSMesaRenderWindow::vtkInternals
{
public:
  std::unique_ptr<vtkOITOSMesaContext> Context;
  std::vector<vtkOITOSMesaContext::Binding> Stack;
  // Frames begun and not ended: End() undoes what Start() did, so it must not run alone.
  int Started = 0;
  std::string Report;
};

//------------------------------------------------------------------------------
vtkOITOSMesaRenderWindow::vtkOITOSMesaRenderWindow()
  : Internals(new vtkInternals)
{
  this->SetWindowName("vtkOIT OSMesa");
  // A buffer in memory is not swapped; the context has no back buffer either.
  this->DoubleBuffer = 0;
  this->StencilCapable = 0;
}

//------------------------------------------------------------------------------
vtkOITOSMesaRenderWindow::~vtkOITOSMesaRenderWindow()
{
  // The base classes still talk to the renderers when they are destroyed, and the renderers to
  // OpenGL; by then the context is gone, so everything that needs it happens here.
  this->Finalize();
  vtkCollectionSimpleIterator cookie;
  this->Renderers->InitTraversal(cookie);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(cookie))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::Initialize()
{
  if (!this->Internals->Context)
  {
    this->CreateAWindow();
  }
  else if (!this->Initialized)
  {
    this->MakeCurrent();
    this->OpenGLInit();
  }
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::CreateAWindow()
{
  auto* shared = vtkOITOSMesaRenderWindow::SafeDownCast(this->SharedRenderWindow);
  std::string error;
  this->Internals->Context =
    vtkOITOSMesaContext::Create(shared ? shared->Internals->Context.get() : nullptr, error);
  if (this->Internals->Context)
  {
    error = vtkOITOSMesaRedirection::Update();
    if (error.empty() && !this->Internals->Context->MakeCurrent())
    {
      error = "OSMesa cannot make its context current";
    }
  }
  if (!error.empty())
  {
    this->Internals->Context.reset();
    vtkErrorMacro("no OpenGL context: " << error << ".");
    return;
  }
  vtkOITOSMesaLiveWindows::Get().Add(this);
  this->Mapped = 1;
  this->OwnContext = 1;
  this->OpenGLInit();
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::DestroyWindow()
{
  if (!this->Internals->Context)
  {
    return;
  }
  const vtkOITOSMesaContext::Binding before = vtkOITOSMesaContext::GetBinding();
  if (vtkOITOSMesaContext::FindLossByFork().empty())
  {
    this->MakeCurrent();
    this->ReleaseGraphicsResources(this);
  }
  vtkOITOSMesaLiveWindows::Get().Remove(this);
  this->Internals->Context.reset();
  vtkOITOSMesaContext::Restore(before);
  this->Internals->Stack.clear();
  this->Internals->Started = 0;
  this->Mapped = 0;
  this->LastMultiSamples = -1;
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::Finalize()
{
  this->DestroyWindow();
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::WindowRemap()
{
  this->Finalize();
  this->Initialize();
}

//------------------------------------------------------------------------------
bool vtkOITOSMesaRenderWindow::Prepare()
{
  this->Initialize();
  if (!this->Internals->Context || !this->Initialized)
  {
    return false;
  }
  std::string error = vtkOITOSMesaContext::FindLossByFork();
  if (error.empty())
  {
    // Libraries that were loaded since the last frame may bring mappers that call OpenGL.
    error = vtkOITOSMesaRedirection::Update();
  }
  if (!error.empty())
  {
    vtkErrorMacro("nothing is drawn: " << error << ".");
    return false;
  }

  this->MakeCurrent();
  GLint limit = 0;
  this->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (std::max(this->Size[0], this->Size[1]) > limit)
  {
    vtkErrorMacro("nothing is drawn: the window has "
      << this->Size[0] << " by " << this->Size[1] << " pixels and OpenGL takes at most " << limit
      << " by " << limit << "; set a smaller size.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::Render()
{
  if (this->InRender || this->Prepare())
  {
    this->Superclass::Render();
  }
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::Start()
{
  if (this->Prepare())
  {
    this->Superclass::Start();
    ++this->Internals->Started;
  }
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::Frame()
{
  if (this->HasFrame())
  {
    this->MakeCurrent();
    this->Superclass::Frame();
  }
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::End()
{
  if (this->Internals->Started > 0)
  {
    --this->Internals->Started;
    this->MakeCurrent();
    this->Superclass::End();
  }
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::MakeCurrent()
{
  if (this->Internals->Context && !this->Internals->Context->MakeCurrent())
  {
    vtkErrorMacro("OSMesa cannot make the context of this window current.");
  }
}

//------------------------------------------------------------------------------
bool vtkOITOSMesaRenderWindow::IsCurrent()
{
  return this->Internals->Context && this->Internals->Context->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::PushContext()
{
  this->Internals->Stack.push_back(vtkOITOSMesaContext::GetBinding());
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::PopContext()
{
  if (!this->Internals->Stack.empty())
  {
    vtkOITOSMesaContext::Restore(this->Internals->Stack.back());
    this->Internals->Stack.pop_back();
  }
}

//------------------------------------------------------------------------------
void* vtkOITOSMesaRenderWindow::GetGenericContext()
{
  return this->Internals->Context ? this->Internals->Context->GetHandle() : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkOITOSMesaRenderWindow::ReportCapabilities()
{
  this->Initialize();
  std::ostringstream report;
  report << "window:  " << this->GetClassName() << " (OSMesa, no display)\n";
  report << (this->Internals->Context ? this->Superclass::ReportCapabilities()
                                      : "no OpenGL context\n");
  this->Internals->Report = report.str();
  return this->Internals->Report.c_str();
}

//------------------------------------------------------------------------------
int* vtkOITOSMesaRenderWindow::GetScreenSize()
{
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  return this->ScreenSize;
}

//------------------------------------------------------------------------------
bool vtkOITOSMesaRenderWindow::HasFrame()
{
  return this->Internals->Context && this->Initialized && this->RenderFramebuffer->GetFBOIndex() &&
    vtkOITOSMesaContext::FindLossByFork().empty();
}

//------------------------------------------------------------------------------
int vtkOITOSMesaRenderWindow::ReadPixels(
  const vtkRecti& rectangle, int front, int format, int type, void* data, int right)
{
  return this->HasFrame()
    ? this->Superclass::ReadPixels(rectangle, front, format, type, data, right)
    : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkOITOSMesaRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  return this->HasFrame() ? this->Superclass::GetZbufferData(x1, y1, x2, y2, z) : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkOITOSMesaRenderWindow::SetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  return this->HasFrame() ? this->Superclass::SetZbufferData(x1, y1, x2, y2, z) : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkOITOSMesaRenderWindow::SetPixelData(
  int x1, int y1, int x2, int y2, unsigned char* data, int front, int right)
{
  return this->HasFrame() ? this->Superclass::SetPixelData(x1, y1, x2, y2, data, front, right)
                          : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkOITOSMesaRenderWindow::SetRGBAPixelData(
  int x1, int y1, int x2, int y2, float* data, int front, int blend, int right)
{
  return this->HasFrame()
    ? this->Superclass::SetRGBAPixelData(x1, y1, x2, y2, data, front, blend, right)
    : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkOITOSMesaRenderWindow::SetRGBACharPixelData(
  int x1, int y1, int x2, int y2, unsigned char* data, int front, int blend, int right)
{
  return this->HasFrame()
    ? this->Superclass::SetRGBACharPixelData(x1, y1, x2, y2, data, front, blend, right)
    : VTK_ERROR;
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::ReleaseGraphicsResources(vtkWindow* window)
{
  // Without a context nothing was made that could be released.
  if (this->Internals->Context)
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkOITOSMesaRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenericContext: " << this->GetGenericContext() << "\n";
}
