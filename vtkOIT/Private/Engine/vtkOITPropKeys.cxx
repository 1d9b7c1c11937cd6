// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Engine/vtkOITPropKeys.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkSmartPointer.h"

#include <vector>

//------------------------------------------------------------------------------
// Not by vtkInformation::Append() as VTK does: in VTK 9.1 it takes a reference that is lost where the
// keys are replaced while drawing, which assemblies do to their parts.
vtkOITPropKeys::vtkOITPropKeys(const vtkRenderState* state, vtkOpenGLRenderPass* pass)
  : State(state)
  , Pass(pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  vtkProp** first = state->GetPropArray();
  for (vtkProp** prop = first; prop != first + state->GetPropArrayCount(); ++prop)
  {
    if (!(*prop)->GetPropertyKeys())
    {
      (*prop)->SetPropertyKeys(vtkNew<vtkInformation>());
    }
    vtkInformation* keys = (*prop)->GetPropertyKeys();
    keys->Set(passes, pass, keys->Length(passes));
  }
}

//------------------------------------------------------------------------------
// Wherever the pass still is.
vtkOITPropKeys::~vtkOITPropKeys()
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  vtkProp** first = this->State->GetPropArray();
  for (vtkProp** prop = first; prop != first + this->State->GetPropArrayCount(); ++prop)
  {
    vtkInformation* keys = (*prop)->GetPropertyKeys();
    if (!keys)
    {
      continue;
    }
    std::vector<vtkSmartPointer<vtkObjectBase>> others;
    for (int i = 0; i < keys->Length(passes); ++i)
    {
      if (keys->Get(passes, i) != this->Pass)
      {
        others.emplace_back(keys->Get(passes, i));
      }
    }
    keys->Remove(passes);
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      keys->Set(passes, others[i], static_cast<int>(i));
    }
  }
}
