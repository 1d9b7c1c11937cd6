// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITSolidDepth.h"

#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITABufferSolidFS.h"

#include "vtkActor.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"

#include <algorithm>
#include <iterator>

/// A pass of its own, so that mappers keep its shaders apart from those of Gather.
class vtkOITSolidStage : public vtkOpenGLRenderPass
{
public:
  static vtkOITSolidStage* New();
  vtkTypeMacro(vtkOITSolidStage, vtkOpenGLRenderPass);

  void Render(const vtkRenderState* state) override
  {
    this->PreRender(state);
    this->Delegate->Render(state);
    this->PostRender(state);
  }

  bool PostReplaceShaderValues(
    std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*) override
  {
    return vtkOITWrapFragmentShader(fragmentShader, "", vtkOITABufferSolidFS);
  }

  bool SetShaderParameters(
    vtkShaderProgram*, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject* = nullptr) override
  {
    this->GLState->vtkglDepthMask(GL_TRUE); // actors turn it off when they are translucent
    return true;
  }

  vtkRenderPass* Delegate = nullptr;
  vtkOpenGLState* GLState = nullptr;

protected:
  vtkOITSolidStage() = default;
  ~vtkOITSolidStage() override = default;

private:
  vtkOITSolidStage(const vtkOITSolidStage&) = delete;
  void operator=(const vtkOITSolidStage&) = delete;
};

vtkStandardNewMacro(vtkOITSolidStage);

namespace
{
/// Whether scalars are mapped, to opacities that may be 1; true without scalars.
bool HasSolidColor(vtkMapper* mapper)
{
  if (!mapper->GetScalarVisibility() || mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS)
  {
    return true;
  }
  int isOfCells = 0;
  vtkDataSet* input = mapper->GetInput(); // nullptr for composite data
  auto* table = vtkLookupTable::SafeDownCast(mapper->GetLookupTable());
  if (!table || !input ||
    !vtkAbstractMapper::GetAbstractScalars(input, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isOfCells))
  {
    return true;
  }
  table->Build();
  const auto isSolid = [](const double* color) { return color[3] >= 1.0; };
  bool found = (table->GetUseBelowRangeColor() && isSolid(table->GetBelowRangeColor())) ||
    (table->GetUseAboveRangeColor() && isSolid(table->GetAboveRangeColor()));
  for (vtkIdType i = 0; i < table->GetNumberOfTableValues() && !found; ++i)
  {
    found = isSolid(table->GetTableValue(i));
  }
  return found;
}

bool CanBeSolid(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetMapper() && actor->GetProperty()->GetOpacity() >= 1.0 &&
    HasSolidColor(actor->GetMapper());
}
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITFindSolidProps(const std::vector<vtkProp*>& props)
{
  std::vector<vtkProp*> solid;
  std::copy_if(props.begin(), props.end(), std::back_inserter(solid), CanBeSolid);
  return solid;
}

//------------------------------------------------------------------------------
vtkOITSolidDepth::vtkOITSolidDepth()
  : Stage(vtkSmartPointer<vtkOITSolidStage>::New())
{
}

//------------------------------------------------------------------------------
vtkOITSolidDepth::~vtkOITSolidDepth() = default;

//------------------------------------------------------------------------------
bool vtkOITSolidDepth::Render(
  vtkOITFrame& frame, vtkRenderPass* delegate, const std::vector<vtkProp*>& props, int unit)
{
  vtkOpenGLState* state = frame.GLState;
  const vtkOITRectangle& r = frame.Rectangle;
  this->Depth.Copy(frame, frame.FindStorage(r), r, unit);
  this->Depth.Unbind(state, unit);
  const bool isComplete = this->Bind(frame);
  if (isComplete)
  {
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(r.X, r.Y, r.Width, r.Height);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    this->Stage->Delegate = delegate;
    this->Stage->GLState = state;
    const std::vector<vtkProp*> all = frame.GetProps();
    frame.DrawOnly(props);
    this->Stage->Render(frame.GetState());
    frame.DrawOnly(all);
    state->vtkglDepthMask(GL_FALSE);
    this->Stage->Delegate = nullptr;
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.Target.Framebuffer);
  return isComplete;
}

//------------------------------------------------------------------------------
bool vtkOITSolidDepth::Bind(const vtkOITFrame& frame)
{
  return this->Framebuffer.Bind(frame.Window, {}, this->Depth.GetAttachment());
}

//------------------------------------------------------------------------------
std::int64_t vtkOITSolidDepth::GetBytes(const vtkOITFrame& frame)
{
  return vtkOITDepthCopy::GetBytes(frame.FindStorage(frame.Rectangle), frame.Target);
}

//------------------------------------------------------------------------------
void vtkOITSolidDepth::Release()
{
  this->Depth.Release();
  this->Framebuffer.Release();
}
