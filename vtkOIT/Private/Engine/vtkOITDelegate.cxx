// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Engine/vtkOITDelegate.h"

#include "Private/Engine/vtkOITGather.h"
#include "Private/Engine/vtkOITGatherHook.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace
{
/// The state that the pass was given, with other props.
class PartState
{
public:
  PartState(const vtkRenderState* state, const std::vector<vtkProp*>& props)
    : Props(props)
    , State(state->GetRenderer())
  {
    this->State.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
    this->State.SetFrameBuffer(state->GetFrameBuffer());
    this->State.SetRequiredKeys(state->GetRequiredKeys());
  }
  const vtkRenderState* Get() const { return &this->State; }

private:
  std::vector<vtkProp*> Props;
  vtkRenderState State;
};

/// A prop that draws nothing, and notices when it is its turn.
class Mark : public vtkProp
{
public:
  static Mark* New();
  vtkTypeMacro(Mark, vtkProp);

  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 1; }
  bool HasKeys(vtkInformation*) override { return true; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override
  {
    this->Notice();
    return 0;
  }

  std::function<void()> Notice;
};
vtkStandardNewMacro(Mark);
}

//------------------------------------------------------------------------------
// After each prop the delegate draws a mark, which tells whether the prop has called the hook.
vtkOITFailure vtkOITDelegate::Draw(const std::vector<vtkProp*>& props, vtkOITGather& gather)
{
  vtkOITGatherHook* hook = gather.GetHook();
  std::size_t drawn = 0;
  vtkNew<Mark> mark;
  mark->Notice = [this, hook, &props, &drawn]
  {
    if (hook->TakeNumberOfDraws() == 0 && drawn < props.size())
    {
      this->Ungathered.insert(props[drawn]);
    }
    ++drawn;
  };
  std::vector<vtkProp*> marked;
  for (vtkProp* prop : props)
  {
    marked.push_back(prop);
    marked.push_back(mark);
  }
  vtkOITFailure failure = hook->RenderBy(
    this->Pass, PartState(this->State, props).Get(), PartState(this->State, marked).Get());
  this->Note(props);
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITDelegate::DrawUnsorted(const std::vector<vtkProp*>& props)
{
  this->Pass->Render(PartState(this->State, props).Get());
  this->Note(props);
}

//------------------------------------------------------------------------------
void vtkOITDelegate::Note(const std::vector<vtkProp*>& props)
{
  ++this->NumberOfPasses;
  if (this->Pass->GetNumberOfRenderedProps() > 0)
  {
    this->Rendered.insert(props.begin(), props.end());
  }
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITFindTranslucentProps(const vtkRenderState* state)
{
  vtkProp** first = state->GetPropArray();
  std::vector<vtkProp*> props;
  std::copy_if(first, first + state->GetPropArrayCount(), std::back_inserter(props),
    [state](vtkProp* prop)
    {
      return prop->GetVisibility() && prop->HasTranslucentPolygonalGeometry() &&
        prop->HasKeys(state->GetRequiredKeys());
    });
  return props;
}
