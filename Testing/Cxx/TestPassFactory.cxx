// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The list of methods by name, and what each pass starts with.

#include "Rig/Report.h"

#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucentPass.h"

#include <set>
#include <sstream>

using namespace vtkOITTest;

int TestPassFactory(int, char*[])
{
  Report report;
  report.SetContext("factory");
  const int count = vtkOITPassFactory::GetNumberOfMethods();
  report.Check(count > 0, "there are no methods");
  std::set<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    const std::string name = vtkOITPassFactory::GetMethodName(i);
    names.insert(name);
    auto pass = vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass(name));
    if (!report.Check(pass, "no pass for " + name))
    {
      continue;
    }
    report.Check(!pass->GetAlgorithmName().empty(), name + " has no algorithm name");
    report.Check(vtkTranslucentPass::SafeDownCast(pass->GetTranslucentPass()),
      name + " starts without a vtkTranslucentPass");
    report.Check(pass->GetMaximumNumberOfPeels() == 0, name + ": peels are limited");
    report.Check(pass->GetOcclusionRatio() == 0.0, name + ": has an occlusion ratio");
    report.Check(pass->GetMaximumBufferSize() == 0, name + ": the storage is limited");
    report.Check(pass->GetNumberOfGeometryPasses() == 0, name + ": has rendered already");
    report.Check(pass->GetBufferSizeInBytes() == 0, name + ": holds buffers already");
    report.Check(
      pass->GetTransmittanceThreshold() == 1.0 / 512.0, name + ": another transmittance threshold");
    report.Check(pass->GetFragmentPrecision() == vtkOITPass::HALF, name + ": another precision");

    std::ostringstream text;
    pass->Print(text);
    for (const char* property : { "TranslucentPass", "VolumetricPass", "MaximumNumberOfPeels",
           "OcclusionRatio", "MaximumBufferSize", "NumberOfGeometryPasses", "NumberOfFragments",
           "MaximumDepthComplexity", "BufferSizeInBytes", "Exact", "ErrorBound" })
    {
      report.Check(
        text.str().find(property) != std::string::npos, name + ": PrintSelf lacks " + property);
    }
  }
  report.Check(names.size() == static_cast<std::size_t>(count), "names are not unique");
  report.Check(names.count("abuffer") == 1, "abuffer is missing");
  report.Check(vtkOITPassFactory::GetMethodName(-1).empty(), "a method at -1");
  report.Check(vtkOITPassFactory::GetMethodName(count).empty(), "a method after the last");
  report.Check(!vtkOITPassFactory::CreatePass("no such method"), "a pass for an unknown name");
  report.Check(!vtkOITPassFactory::CreatePass(""), "a pass for an empty name");
  return report.GetExitStatus();
}
