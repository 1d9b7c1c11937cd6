// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// All setters treat a value that is out of range, or not a number, alike: one line of error that
// names the property and says what to do, and the old value stays.

#include "Rig/Report.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOITAutoPass.h"
#include "vtkOITBucketPeelingPass.h"
#include "vtkOITDeferredPeelingPass.h"
#include "vtkOITMultiLayerPeelingPass.h"
#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"
#include "vtkOITWeightedPass.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>

using namespace vtkOITTest;

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/// The errors of an object.
class Listener
{
public:
  explicit Listener(vtkObject* object)
    : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* listener, void* text)
      {
        ++static_cast<Listener*>(listener)->Count;
        static_cast<Listener*>(listener)->Text = static_cast<const char*>(text);
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
  }
  ~Listener() { this->Object->RemoveObserver(this->Command); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  int Count = 0;
  std::string Text;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
};

/// `set` must be refused in one line that names the property.
void CheckRefused(Report& report, vtkObject* object, const std::string& what,
  const std::string& property, const std::function<void()>& set, const std::function<double()>& get)
{
  const double before = get();
  const vtkMTimeType time = object->GetMTime();
  const Listener listener(object);
  set();
  report.Check(get() == before, what + ": the value has changed");
  report.Check(object->GetMTime() == time, what + ": the pass is said to be modified");
  report.Check(listener.Count == 1, what + ": " + std::to_string(listener.Count) + " errors");
  report.Check(listener.Text.find(property) != std::string::npos &&
      listener.Text.find("is refused; ") != std::string::npos,
    what + ": the error is " + listener.Text);
}

void CheckCommon(Report& report, const std::string& name)
{
  auto pass = vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass(name));
  for (const double value : { -0.1, 1.1, NotANumber })
  {
    CheckRefused(
      report, pass, name + ": threshold", "TransmittanceThreshold",
      [&] { pass->SetTransmittanceThreshold(value); },
      [&] { return pass->GetTransmittanceThreshold(); });
  }
  for (const double value : { -0.1, 0.75, NotANumber })
  {
    CheckRefused(
      report, pass, name + ": ratio", "OcclusionRatio", [&] { pass->SetOcclusionRatio(value); },
      [&] { return pass->GetOcclusionRatio(); });
  }
  CheckRefused(
    report, pass, name + ": peels", "MaximumNumberOfPeels",
    [&] { pass->SetMaximumNumberOfPeels(-3); }, [&] { return pass->GetMaximumNumberOfPeels(); });
  for (const vtkTypeInt64 value : { -1, 1000 })
  {
    CheckRefused(
      report, pass, name + ": buffer", "MaximumBufferSize",
      [&] { pass->SetMaximumBufferSize(value); },
      [&] { return static_cast<double>(pass->GetMaximumBufferSize()); });
  }
  for (const int value : { -1, 2 })
  {
    CheckRefused(
      report, pass, name + ": precision", "FragmentPrecision",
      [&] { pass->SetFragmentPrecision(value); }, [&] { return pass->GetFragmentPrecision(); });
  }
  for (const int value : { -1, 2 })
  {
    CheckRefused(
      report, pass, name + ": coincident layers", "CoincidentLayers",
      [&] { pass->SetCoincidentLayers(value); }, [&] { return pass->GetCoincidentLayers(); });
  }
  const vtkMTimeType time = pass->GetMTime();
  report.Check(pass->GetCoincidentLayers() == vtkOITPass::MEAN, name + ": the default is no mean");
  pass->SetCoincidentLayersToLastOnTop();
  report.Check(pass->GetCoincidentLayers() == vtkOITPass::LAST_ON_TOP && pass->GetMTime() > time,
    name + ": LAST_ON_TOP is not taken");
  const Listener listener(pass);
  vtkRenderPass* delegate = pass->GetTranslucentPass();
  pass->SetTranslucentPass(pass);
  report.Check(pass->GetTranslucentPass() == delegate, name + ": is its own delegate");
  report.Check(!pass->GetVolumetricPass(), name + ": starts with a volumetric pass");
  pass->SetVolumetricPass(pass);
  report.Check(!pass->GetVolumetricPass(), name + ": is its own volumetric pass");
  report.Check(listener.Count == 2, name + ": as its own delegate gives no error");
}
}

int TestProperties(int, char*[])
{
  Report report;
  report.SetContext("properties");
  for (int i = 0; i < vtkOITPassFactory::GetNumberOfMethods(); ++i)
  {
    CheckCommon(report, vtkOITPassFactory::GetMethodName(i));
  }
  vtkNew<vtkOITMultiLayerPeelingPass> multiLayer;
  vtkNew<vtkOITBucketPeelingPass> bucket;
  vtkNew<vtkOITDeferredPeelingPass> deferred;
  vtkNew<vtkOITWeightedPass> weighted;
  for (const int value : { -1, 5 })
  {
    CheckRefused(
      report, multiLayer, "layers a pass", "NumberOfLayersPerPass",
      [&] { multiLayer->SetNumberOfLayersPerPass(value); },
      [&] { return multiLayer->GetNumberOfLayersPerPass(); });
    CheckRefused(
      report, multiLayer, "synchronization", "Synchronization",
      [&] { multiLayer->SetSynchronization(value); },
      [&] { return multiLayer->GetSynchronization(); });
    CheckRefused(
      report, bucket, "buckets", "Mode", [&] { bucket->SetMode(value); },
      [&] { return bucket->GetMode(); });
    CheckRefused(
      report, bucket, "depth range", "DepthRange", [&] { bucket->SetDepthRange(value); },
      [&] { return bucket->GetDepthRange(); });
    CheckRefused(
      report, deferred, "deferral", "Mode", [&] { deferred->SetMode(value); },
      [&] { return deferred->GetMode(); });
    CheckRefused(
      report, weighted, "weight", "Mode", [&] { weighted->SetMode(value); },
      [&] { return weighted->GetMode(); });
  }
  CheckRefused(
    report, multiLayer, "float layers", "FragmentPrecision",
    [&] { multiLayer->SetFragmentPrecision(vtkOITPass::FLOAT); },
    [&] { return multiLayer->GetFragmentPrecision(); });

  vtkNew<vtkOITAutoPass> automatic;
  const Listener listener(automatic);
  report.Check(automatic->GetChoice() == automatic->GetAlgorithmReason() && listener.Count == 1,
    "the deprecated name does not warn once");
  return report.GetExitStatus();
}
