// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPeelingEngine_h
#define vtkOITPeelingEngine_h

#include "Private/Engine/vtkOITEngine.h"
#include "Private/Frame/vtkOITBands.h"
#include "Private/Peeling/vtkOITPeelState.h"
#include "Private/Peeling/vtkOITPropCulling.h"

#include <memory>
#include <vector>

class vtkOITPeeler;
struct vtkOITPeelContext;

/// What all methods of peeling share, see vtkOITPeelingPass; a vtkOITPeeler has the rest.
class vtkOITPeelingEngine : public vtkOITEngine
{
public:
  vtkOITPeelingEngine(const char* algorithmName, std::unique_ptr<vtkOITPeeler> peeler);
  ~vtkOITPeelingEngine() override;

  std::string GetAlgorithmName(const vtkOITSettings&) const override { return this->AlgorithmName; }
  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  std::string FindMissingIn(const vtkOITFrame& frame) const override;
  bool UsesStorage(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  vtkOITFailure Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
    vtkOITGeometry& geometry, vtkOITStatistics& statistics) override;
  std::int64_t GetSizeInBytes() const override;
  void Release() override;

protected:
  /// The one for a frame. A method that has several gives another one where it is better.
  virtual vtkOITPeeler& ChoosePeeler(const vtkOITFrame&, const vtkOITSettings&)
  {
    return *this->Peeler;
  }

private:
  /// How the peeling of a band ended in the last frame.
  struct End
  {
    std::size_t Peels = 0;
    bool FirstHadAll = false; // the first peel, not a limit or a threshold
  };

  vtkOITFailure DrawBand(const Task& task, const vtkOITRectangle& band, End& end);
  vtkOITFailure PeelBand(const Task& task, const vtkOITPeelContext& context, End& end);
  vtkOITFailure Composite(
    const Task& task, const vtkOITPeelContext& context, const vtkOITRectangle& band, End& end);
  vtkOITFailure DrawGeometry(const Task& task, const vtkOITPeelContext& context);
  bool IsFinished(std::size_t peels, std::size_t expected, std::int64_t fewestPixels);

  const char* AlgorithmName;
  std::unique_ptr<vtkOITPeeler> Peeler;
  vtkOITPeeler* Chosen; // for the frame
  vtkOITPeelState State;
  vtkOITBands Bands;
  vtkOITPropCulling Culling;
  bool Culls = false;
  std::vector<End> Ends; // of the bands
};

#endif
