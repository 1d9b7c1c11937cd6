// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPartState_h
#define vtkOITPartState_h

#include "vtkProp.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

/// The visible props of the state, with its required keys, of this kind.
template <typename Predicate>
std::vector<vtkProp*> vtkOITFindDrawnProps(const vtkRenderState* state, Predicate isOfKind)
{
  vtkProp** first = state->GetPropArray();
  std::vector<vtkProp*> props;
  std::copy_if(first, first + state->GetPropArrayCount(), std::back_inserter(props),
    [&](vtkProp* prop)
    { return prop->GetVisibility() && isOfKind(prop) && prop->HasKeys(state->GetRequiredKeys()); });
  return props;
}

/// The state that a pass was given, with other props.
class vtkOITPartState
{
public:
  vtkOITPartState(const vtkRenderState* state, std::vector<vtkProp*> props)
    : Props(std::move(props))
    , State(state->GetRenderer())
  {
    this->State.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
    this->State.SetFrameBuffer(state->GetFrameBuffer());
    this->State.SetRequiredKeys(state->GetRequiredKeys());
  }
  vtkOITPartState(const vtkOITPartState&) = delete;
  vtkOITPartState& operator=(const vtkOITPartState&) = delete;

  const vtkRenderState* Get() const { return &this->State; }

private:
  std::vector<vtkProp*> Props;
  vtkRenderState State;
};

#endif
