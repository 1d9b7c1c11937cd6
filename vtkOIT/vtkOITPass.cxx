// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITPass.h"

#include "vtkOITPassFactory.h"

#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITScreenExtents.h"
#include "Private/GL/vtkOITSavedState.h"

#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkOITPass::vtkOITPass()
{
  this->TranslucentPass = vtkSmartPointer<vtkTranslucentPass>::New();
}

//------------------------------------------------------------------------------
vtkOITPass::~vtkOITPass() = default;

//------------------------------------------------------------------------------
void vtkOITPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TranslucentPass: " << this->TranslucentPass.Get() << "\n"
     << indent << "MaximumNumberOfPeels: " << this->MaximumNumberOfPeels << "\n"
     << indent << "OcclusionRatio: " << this->OcclusionRatio << "\n"
     << indent << "MaximumBufferSize: " << this->MaximumBufferSize << "\n"
     << indent << "FragmentPrecision: " << (this->FragmentPrecision == HALF ? "half" : "float")
     << "\n"
     << indent << "NumberOfGeometryPasses: " << this->NumberOfGeometryPasses << "\n"
     << indent << "NumberOfFragments: " << this->NumberOfFragments << "\n"
     << indent << "MaximumDepthComplexity: " << this->MaximumDepthComplexity << "\n"
     << indent << "BufferSizeInBytes: " << this->BufferSizeInBytes << "\n"
     << indent << "Exact: " << this->Exact << "\n"
     << indent << "ErrorBound: " << this->ErrorBound << "\n";
}

//------------------------------------------------------------------------------
void vtkOITPass::SetTranslucentPass(vtkRenderPass* pass)
{
  if (this->TranslucentPass != pass)
  {
    this->TranslucentPass = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkOITPass::GetTranslucentPass()
{
  return this->TranslucentPass;
}

//------------------------------------------------------------------------------
void vtkOITPass::SetMaximumBufferSize(vtkTypeInt64 bytes)
{
  constexpr vtkTypeInt64 smallest = 1 << 20;
  if (bytes < 0 || (bytes > 0 && bytes < smallest))
  {
    vtkErrorMacro("MaximumBufferSize " << bytes << " is refused; give 0 for no limit, or at least "
                                       << smallest << " bytes");
    return;
  }
  if (this->MaximumBufferSize != bytes)
  {
    this->MaximumBufferSize = bytes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkOITPass::GetMissingCapability(vtkOpenGLRenderWindow* window)
{
  if (window && !window->GetNeverRendered())
  {
    window->MakeCurrent();
  }
  return this->FindMissingCapability(vtkOITCapabilities(window));
}

//------------------------------------------------------------------------------
const vtkOITCapabilities& vtkOITPass::QueryCapabilities(vtkOpenGLRenderWindow* window)
{
  if (!this->Capabilities || this->CapabilitiesWindow != window)
  {
    this->Capabilities = std::make_unique<vtkOITCapabilities>(window);
    this->CapabilitiesWindow = window;
  }
  return *this->Capabilities;
}

//------------------------------------------------------------------------------
void vtkOITPass::ResetStatistics()
{
  this->NumberOfRenderedProps = 0;
  this->NumberOfGeometryPasses = 0;
  this->NumberOfFragments = 0;
  this->MaximumDepthComplexity = 0;
  this->Exact = true;
  this->ErrorBound = 0.0;
  this->LastAlgorithmName = nullptr;
}

//------------------------------------------------------------------------------
void vtkOITPass::Render(const vtkRenderState* state)
{
  this->ResetStatistics();
  vtkRenderer* renderer = state->GetRenderer();
  if (!this->TranslucentPass)
  {
    vtkErrorMacro("No TranslucentPass is set; give one with SetTranslucentPass(), e.g. a "
                  "vtkTranslucentPass");
    return;
  }
  if (renderer->GetSelector())
  {
    // A selector draws identifiers, not colours: nothing to sort.
    this->TranslucentPass->Render(state);
    this->NumberOfRenderedProps = this->TranslucentPass->GetNumberOfRenderedProps();
    return;
  }

  vtkOITFrame frame(state, vtkOITFindTranslucentProps(state));
  if (frame.GetState()->GetPropArrayCount() == 0)
  {
    return;
  }
  if (!frame.Window)
  {
    this->RenderUnsorted(state, "the renderer's window is not a vtkOpenGLRenderWindow");
    return;
  }
  vtkOpenGLClearErrorMacro();
  frame.Capabilities = &this->QueryCapabilities(frame.Window);
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  frame.Viewport = { viewport[0], viewport[1], viewport[2], viewport[3] };
  frame.Extents = vtkOITFindScreenExtents(renderer, frame.GetProps(), frame.Viewport);
  frame.Rectangle = vtkOITFindScreenRectangle(frame.Extents);
  if (glIsEnabled(GL_SCISSOR_TEST))
  {
    GLint scissor[4];
    glGetIntegerv(GL_SCISSOR_BOX, scissor);
    frame.Rectangle = frame.Rectangle.Intersect({ scissor[0], scissor[1], scissor[2], scissor[3] });
  }
  if (frame.Rectangle.IsEmpty())
  {
    return;
  }
  frame.Target = vtkOITTarget::Query();
  const std::string missing = this->FindMissing(frame);
  if (missing.empty())
  {
    this->RenderFrame(frame);
  }
  else if (!this->RenderByFallback(frame, missing))
  {
    this->RenderUnsorted(state, missing);
  }
  vtkOpenGLCheckErrorMacro("failed after Render");
}

//------------------------------------------------------------------------------
void vtkOITPass::RenderFrame(vtkOITFrame& frame)
{
  const vtkOITSavedState saved(frame.GLState, frame.Capabilities->HasStorage());
  this->RenderTranslucent(frame);
}

//------------------------------------------------------------------------------
std::string vtkOITPass::FindMissing(const vtkOITFrame& frame)
{
  const std::string missing = this->FindMissingCapability(*frame.Capabilities);
  return missing.empty() ? this->FindMissingInTarget(frame) : missing;
}

//------------------------------------------------------------------------------
std::string vtkOITPass::FindMissingInTarget(const vtkOITFrame&)
{
  return {};
}

//------------------------------------------------------------------------------
// False when no exact method can render the frame.
bool vtkOITPass::RenderByFallback(vtkOITFrame& frame, const std::string& reason)
{
  for (const char* method : { "abuffer", "dual" })
  {
    if (!this->Fallback || this->FallbackMethod != method)
    {
      this->Fallback.TakeReference(vtkOITPassFactory::CreatePass(method));
      this->FallbackMethod = method;
    }
    vtkOITPass& pass = *this->Fallback;
    if (!pass.IsA(this->GetClassName()) && pass.FindMissing(frame).empty())
    {
      this->Report("Rendered by another exact method: ", reason);
      pass.SetMaximumBufferSize(this->MaximumBufferSize);
      this->RenderBy(pass, frame);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkOITPass::RenderBy(vtkOITPass& pass, vtkOITFrame& frame)
{
  pass.SetTranslucentPass(this->TranslucentPass);
  pass.SetFragmentPrecision(this->FragmentPrecision);
  pass.ResetStatistics();
  pass.RenderFrame(frame);
  this->NumberOfRenderedProps += pass.NumberOfRenderedProps;
  this->NumberOfGeometryPasses += pass.NumberOfGeometryPasses;
  this->NumberOfFragments += pass.NumberOfFragments;
  this->MaximumDepthComplexity =
    std::max(this->MaximumDepthComplexity, pass.MaximumDepthComplexity);
  this->BufferSizeInBytes = pass.BufferSizeInBytes;
  this->Exact = this->Exact && pass.Exact;
  this->ErrorBound = std::max(this->ErrorBound, pass.ErrorBound);
  this->LastAlgorithmName = pass.GetOwnAlgorithmName();
}

//------------------------------------------------------------------------------
void vtkOITPass::Report(const char* consequence, const std::string& reason)
{
  if (this->ReportedReason != reason)
  {
    vtkWarningMacro(<< consequence << reason);
    this->ReportedReason = reason;
  }
}

//------------------------------------------------------------------------------
const char* vtkOITPass::GetAlgorithmName()
{
  return this->LastAlgorithmName ? this->LastAlgorithmName : this->GetOwnAlgorithmName();
}

//------------------------------------------------------------------------------
void vtkOITPass::RenderUnsorted(const vtkRenderState* state, const std::string& reason)
{
  this->Report("Translucent props are blended unsorted: ", reason);
  this->LastAlgorithmName = "unsorted blending";
  this->TranslucentPass->Render(state);
  this->NumberOfRenderedProps = this->TranslucentPass->GetNumberOfRenderedProps();
  this->NumberOfGeometryPasses = 1;
  this->NumberOfFragments = -1;
  this->MaximumDepthComplexity = -1;
  this->Exact = false;
  this->ErrorBound = 1.0;
}

//------------------------------------------------------------------------------
void vtkOITPass::RenderGeometry(vtkOITFrame& frame)
{
  this->PreRender(frame.GetState());
  this->TranslucentPass->Render(frame.GetState());
  this->PostRender(frame.GetState());
  this->NumberOfRenderedProps = this->TranslucentPass->GetNumberOfRenderedProps();
  ++this->NumberOfGeometryPasses;
}

//------------------------------------------------------------------------------
void vtkOITPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->TranslucentPass)
  {
    this->TranslucentPass->ReleaseGraphicsResources(window);
  }
  if (this->Fallback)
  {
    this->Fallback->ReleaseGraphicsResources(window);
  }
  this->Capabilities.reset();
  this->CapabilitiesWindow = nullptr;
  this->BufferSizeInBytes = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
