// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Hook/vtkOITPassChain.h"

#include "vtkCameraPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"

namespace
{
constexpr int DeepestChain = 16; // one that contains itself ends there

bool IsTranslucentPassOfVTK(vtkRenderPass* pass)
{
  return vtkTranslucentPass::SafeDownCast(pass) || vtkDepthPeelingPass::SafeDownCast(pass) ||
    vtkOrderIndependentTranslucentPass::SafeDownCast(pass);
}

/// ParaView's classes, known by name: no library of its is loaded elsewhere. The second one composites
/// what the ranks of a server have drawn by the first.
bool IsRendererItself(vtkRenderPass* pass)
{
  return pass->IsA("vtkPVDefaultPass") || pass->IsA("vtkIceTCompositePass");
}
}

//------------------------------------------------------------------------------
bool vtkOITPassChain::Put(vtkRenderPass* chain, vtkRenderPass* pass)
{
  this->IsIn = false;
  this->AsksRenderer = false;
  this->Fill(chain, pass, 0, {});
  return this->IsIn;
}

//------------------------------------------------------------------------------
void vtkOITPassChain::GiveBack()
{
  for (const Slot& slot : this->Slots)
  {
    slot.Set(slot.Before);
  }
  this->Slots.clear();
}

//------------------------------------------------------------------------------
// `set` changes what the slot contains; none for the start of the chain.
void vtkOITPassChain::Fill(
  vtkRenderPass* content, vtkRenderPass* pass, int depth, const Setter& set)
{
  if (content == pass)
  {
    this->IsIn = true;
  }
  else if (set && IsTranslucentPassOfVTK(content))
  {
    this->Slots.push_back({ content, set });
    set(pass);
    this->IsIn = true;
  }
  else if (content && depth < DeepestChain)
  {
    this->Visit(content, pass, depth + 1);
  }
}

//------------------------------------------------------------------------------
void vtkOITPassChain::Visit(vtkRenderPass* chain, vtkRenderPass* pass, int depth)
{
  const vtkSmartPointer<vtkRenderPass> owner = chain; // as long as the setter
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(chain))
  {
    this->Fill(steps->GetTranslucentPass(), pass, depth,
      [owner, steps](vtkRenderPass* content) { steps->SetTranslucentPass(content); });
    this->Fill(steps->GetPostProcessPass(), pass, depth, {});
  }
  else if (auto* sequence = vtkSequencePass::SafeDownCast(chain))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    for (int i = 0; passes && i < passes->GetNumberOfItems(); ++i)
    {
      this->Fill(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)), pass, depth,
        [owner, passes, i](vtkRenderPass* content) { passes->ReplaceItem(i, content); });
    }
  }
  else if (auto* camera = vtkCameraPass::SafeDownCast(chain))
  {
    this->Fill(camera->GetDelegatePass(), pass, depth,
      [owner, camera](vtkRenderPass* content) { camera->SetDelegatePass(content); });
  }
  else if (auto* image = vtkImageProcessingPass::SafeDownCast(chain))
  {
    this->Fill(image->GetDelegatePass(), pass, depth,
      [owner, image](vtkRenderPass* content) { image->SetDelegatePass(content); });
  }
  else if (auto* ssaa = vtkSSAAPass::SafeDownCast(chain))
  {
    this->Fill(ssaa->GetDelegatePass(), pass, depth,
      [owner, ssaa](vtkRenderPass* content) { ssaa->SetDelegatePass(content); });
  }
  else if (IsRendererItself(chain))
  {
    this->AsksRenderer = true;
  }
}
