// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBucketPeelingEngine_h
#define vtkOITBucketPeelingEngine_h

#include "Private/Frame/vtkOITSettings.h"
#include "Private/Peeling/vtkOITBucketPeeler.h"
#include "Private/Peeling/vtkOITBucketShotPeeler.h"
#include "Private/Peeling/vtkOITPeelingEngine.h"

#include <memory>

/// Bucket depth peeling: a single shot where one peel is wanted, otherwise to the end.
class vtkOITBucketPeelingEngine : public vtkOITPeelingEngine
{
public:
  vtkOITBucketPeelingEngine()
    : vtkOITPeelingEngine("bucket depth peeling", std::make_unique<vtkOITBucketPeeler>())
  {
  }

protected:
  vtkOITPeeler& ChoosePeeler(const vtkOITFrame& frame, const vtkOITSettings& settings) override
  {
    return settings.MaximumNumberOfPeels == 1 ? this->ShotPeeler
                                              : vtkOITPeelingEngine::ChoosePeeler(frame, settings);
  }

private:
  vtkOITBucketShotPeeler ShotPeeler;
};

#endif
