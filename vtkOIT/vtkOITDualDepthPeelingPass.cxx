// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITDualDepthPeelingPass.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Peeling/vtkOITDualPeeler.h"
#include "Private/Peeling/vtkOITMinMaxPeeler.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkOITDualDepthPeelingPass);

//------------------------------------------------------------------------------
vtkOITDualDepthPeelingPass::vtkOITDualDepthPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITMinMaxPeeler>(true))
{
}

//------------------------------------------------------------------------------
vtkOITDualDepthPeelingPass::~vtkOITDualDepthPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITDualDepthPeelingPass::RenderTranslucent(vtkOITFrame& frame)
{
  const bool keepsLayers = vtkOITPeelState::CanWorkInPlace(frame);
  if (keepsLayers && !this->LayerPeeler)
  {
    auto peeler = std::make_unique<vtkOITDualPeeler>();
    this->LayerPeeler = peeler.get();
    this->SetPeeler(std::move(peeler));
  }
  else if (!keepsLayers && this->LayerPeeler)
  {
    this->LayerPeeler = nullptr;
    this->SetPeeler(std::make_unique<vtkOITMinMaxPeeler>(true));
  }
  if (this->LayerPeeler)
  {
    this->LayerPeeler->SetLayersPerSide(this->LayersPerSide);
  }
  this->Superclass::RenderTranslucent(frame);
  if (this->LayerPeeler && this->FragmentPrecision == HALF)
  {
    this->ChooseLayersPerSide();
  }
}

//------------------------------------------------------------------------------
// As few as take all layers in one peel, because a layer costs a buffer that each fragment reads
// and writes; as many as there can be when one peel is not enough. More at once, fewer only when
// some frames agree: other shaders are looked up for it.
void vtkOITDualDepthPeelingPass::ChooseLayersPerSide()
{
  constexpr int framesToAgree = 3;
  const int layers = this->MaximumDepthComplexity;
  const int wanted = std::min((std::max(layers, 1) + 1) / 2, vtkOITDualPeeler::MostLayersPerSide);
  this->FramesWithFewer = wanted < this->LayersPerSide ? this->FramesWithFewer + 1 : 0;
  if (wanted > this->LayersPerSide || this->FramesWithFewer >= framesToAgree)
  {
    this->LayersPerSide = wanted;
    this->FramesWithFewer = 0;
    this->ForgetNumberOfPeels();
  }
}

//------------------------------------------------------------------------------
void vtkOITDualDepthPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
