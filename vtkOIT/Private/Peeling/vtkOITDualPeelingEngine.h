// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDualPeelingEngine_h
#define vtkOITDualPeelingEngine_h

#include "Private/Peeling/vtkOITDualPeeler.h"
#include "Private/Peeling/vtkOITMinMaxPeeler.h"
#include "Private/Peeling/vtkOITPeelingEngine.h"

/// Dual depth peeling: keeps layers where shaders read the framebuffer, otherwise finds their
/// depths first.
class vtkOITDualPeelingEngine : public vtkOITPeelingEngine
{
public:
  vtkOITDualPeelingEngine()
    : vtkOITPeelingEngine("dual depth peeling", std::make_unique<vtkOITMinMaxPeeler>(true))
  {
  }

protected:
  vtkOITPeeler& ChoosePeeler(const vtkOITFrame& frame, const vtkOITSettings& settings) override
  {
    return vtkOITPeelState::CanWorkInPlace(frame)
      ? this->LayerPeeler
      : vtkOITPeelingEngine::ChoosePeeler(frame, settings);
  }

private:
  vtkOITDualPeeler LayerPeeler;
};

#endif
