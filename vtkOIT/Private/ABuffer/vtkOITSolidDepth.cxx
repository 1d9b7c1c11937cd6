// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITSolidDepth.h"

#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Engine/vtkOITPropParts.h"
#include "Private/Frame/vtkOITFrame.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITABufferSolidFS.h"
#include "vtkOITFragmentFS.h"

#include "vtkActor.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"

#include <algorithm>
#include <iterator>

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
  return actor && actor->GetMapper() && !vtkOITAddsLight(prop) && actor->GetProperty()->GetOpacity() >= 1.0 &&
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
{
  this->Gather.SetStage(vtkOITShaderText({ vtkOITFragmentFS, vtkOITABufferSolidFS }));
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITSolidDepth::Render(
  const vtkOITFrame& frame, const std::vector<vtkProp*>& props, vtkOITGeometry& geometry)
{
  vtkOpenGLState* state = frame.GLState;
  const vtkOITRectangle& r = frame.Rectangle;
  vtkOITFailure failure = this->Depth.Copy(frame, frame.FindStorage(r), r, OIT_UNIT_DEPTH);
  if (failure)
  {
    return failure;
  }
  this->Depth.Unbind(state, OIT_UNIT_DEPTH);
  failure = this->Bind(frame);
  if (failure)
  {
    return failure;
  }
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  this->Gather.SetUniforms([state](vtkShaderProgram*, vtkProp*)
    { state->vtkglDepthMask(GL_TRUE); }); // actors turn it off when they are translucent
  failure = geometry.Draw(props, this->Gather);
  state->vtkglDepthMask(GL_FALSE);
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITSolidDepth::Bind(const vtkOITFrame& frame)
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
