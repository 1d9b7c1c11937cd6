// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDeferredEngine_h
#define vtkOITDeferredEngine_h

#include "Private/ABuffer/vtkOITABufferEngine.h"
#include "Private/Peeling/vtkOITPeelingEngine.h"

#include <array>

/// The ways to light layers after they were sorted, see vtkOITDeferredPeelingPass: one peel after
/// another, or all at once in the A-buffer. With CoincidentLayers LAST_ON_TOP depth peeling keeps the
/// order, and mappers light.
class vtkOITDeferredEngine : public vtkOITEngine
{
public:
  vtkOITDeferredEngine();

  /// One peel after another, or all at once (default).
  void SetPeels(bool peels) { this->Peels = peels; }

  std::string GetAlgorithmName(const vtkOITSettings& settings) const override;
  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  std::string FindMissingIn(const vtkOITFrame& frame) const override;
  bool UsesStorage(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  bool MixesVolumes() const override { return !this->Peels; }
  bool SortsLight() const override { return !this->Peels; }
  vtkOITFailure Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
    vtkOITGeometry& geometry, vtkOITStatistics& statistics) override;
  std::int64_t GetSizeInBytes() const override;
  void Release() override;

private:
  vtkOITEngine& Choose(const vtkOITSettings& settings) const;

  vtkOITABufferEngine ABuffer;
  vtkOITPeelingEngine Peeling;
  vtkOITPeelingEngine LitPeeling; // by mappers
  std::array<vtkOITEngine*, 3> All = { &this->ABuffer, &this->Peeling, &this->LitPeeling };
  bool Peels = false;
};

#endif
