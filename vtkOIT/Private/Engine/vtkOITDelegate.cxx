// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Engine/vtkOITDelegate.h"

#include "Private/Engine/vtkOITGather.h"
#include "Private/Engine/vtkOITGatherHook.h"
#include "Private/Engine/vtkOITPartState.h"
#include "Private/Engine/vtkOITPropParts.h"

#include "vtkProp.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDelegate::Draw(const std::vector<vtkProp*>& props, vtkOITGather& gather)
{
  vtkOITFailure failure = this->DrawHooked(props, gather);
  this->Note(props);
  return failure;
}

//------------------------------------------------------------------------------
int vtkOITDelegate::Try(vtkProp* prop, vtkOITGather& gather)
{
  // What fails here, fails again when the prop is drawn.
  static_cast<void>(this->DrawHooked({ prop }, gather));
  return gather.GetHook()->GetNumberOfDraws();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDelegate::DrawHooked(const std::vector<vtkProp*>& props, vtkOITGather& gather)
{
  std::vector<vtkProp*> hooked = props;
  const std::vector<vtkProp*> parts = vtkOITFindParts(props);
  hooked.insert(hooked.end(), parts.begin(), parts.end());
  return gather.GetHook()->RenderBy(this->Pass, vtkOITPartState(this->State, hooked).Get(),
    vtkOITPartState(this->State, props).Get());
}

//------------------------------------------------------------------------------
bool vtkOITDelegate::DrawUnsorted(const std::vector<vtkProp*>& props)
{
  this->Pass->Render(vtkOITPartState(this->State, props).Get());
  return this->Note(props);
}

//------------------------------------------------------------------------------
bool vtkOITDelegate::TryUnsorted(vtkProp* prop)
{
  this->Pass->Render(vtkOITPartState(this->State, { prop }).Get());
  return this->Pass->GetNumberOfRenderedProps() > 0;
}

//------------------------------------------------------------------------------
bool vtkOITDelegate::Note(const std::vector<vtkProp*>& props)
{
  ++this->NumberOfPasses;
  const bool hasDrawn = this->Pass->GetNumberOfRenderedProps() > 0;
  if (hasDrawn)
  {
    this->Rendered.insert(props.begin(), props.end());
  }
  return hasDrawn;
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITFindTranslucentProps(const vtkRenderState* state)
{
  return vtkOITFindDrawnProps(
    state, [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITFindDenyingProps(const vtkRenderState* state)
{
  return vtkOITFindDrawnProps(state,
    [](vtkProp* prop)
    { return !vtkOITIsSimpleActor(prop) && !prop->HasTranslucentPolygonalGeometry(); });
}
