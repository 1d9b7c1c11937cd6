// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Plan/vtkOITDeferredEngine.h"

#include "Private/Frame/vtkOITSettings.h"
#include "Private/Peeling/vtkOITDeferredPeeler.h"
#include "Private/Peeling/vtkOITMinMaxPeeler.h"

//------------------------------------------------------------------------------
vtkOITDeferredEngine::vtkOITDeferredEngine()
  : Peeling("deferred depth peeling", std::make_unique<vtkOITDeferredPeeler>())
  , LitPeeling("depth peeling", std::make_unique<vtkOITMinMaxPeeler>(false))
{
}

//------------------------------------------------------------------------------
vtkOITEngine& vtkOITDeferredEngine::Choose(const vtkOITSettings& settings) const
{
  return *this->All[this->Peels ? (settings.LastOnTop ? 2 : 1) : 0];
}

//------------------------------------------------------------------------------
std::string vtkOITDeferredEngine::GetAlgorithmName(const vtkOITSettings& settings) const
{
  return this->Choose(settings).GetAlgorithmName(settings);
}

//------------------------------------------------------------------------------
std::string vtkOITDeferredEngine::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  return this->Choose(settings).FindMissing(capabilities, settings);
}

//------------------------------------------------------------------------------
std::string vtkOITDeferredEngine::FindMissingIn(const vtkOITFrame& frame) const
{
  return this->All[this->Peels ? 1 : 0]->FindMissingIn(frame);
}

//------------------------------------------------------------------------------
bool vtkOITDeferredEngine::UsesStorage(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  return this->Choose(settings).UsesStorage(capabilities, settings);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDeferredEngine::Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
  vtkOITGeometry& geometry, vtkOITStatistics& statistics)
{
  vtkOITEngine& chosen = this->Choose(settings);
  for (vtkOITEngine* engine : this->All)
  {
    if (engine != &chosen && engine->GetSizeInBytes() > 0)
    {
      engine->Release(); // the limit on memory is for all together
    }
  }
  return chosen.Draw(frame, settings, geometry, statistics);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITDeferredEngine::GetSizeInBytes() const
{
  std::int64_t bytes = 0;
  for (const vtkOITEngine* engine : this->All)
  {
    bytes += engine->GetSizeInBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkOITDeferredEngine::Release()
{
  for (vtkOITEngine* engine : this->All)
  {
    engine->Release();
  }
}
