// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A method that cannot run is replaced by the best exact one, which is named, and comes back when
// it can run again.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkNew.h"
#include "vtkOITABufferPass.h"
#include "vtkOITDualDepthPeelingPass.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <vtksys/SystemTools.hxx>

using namespace vtkOITTest;

namespace
{
void CheckName(Report& report, vtkOITPass* pass, const std::string& expected)
{
  report.Check(pass->GetAlgorithmName() == expected,
    "rendered by " + std::string(pass->GetAlgorithmName()) + ", expected " + expected);
}
}

int TestFallback(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      if (setup.Tier != "all extensions")
      {
        return;
      }
      vtkObject::GlobalWarningDisplayOff(); // one warning for each reason is what is wanted
      const std::vector<Layer> layers = Random(4).Layers(12);

      vtksys::SystemTools::PutEnv("VTKOIT_HIDE_EXTENSIONS=GL_ARB_shader_storage_buffer_object");
      {
        Rig rig(setup, 16, 12);
        rig.AddStack(layers);
        const Image image = rig.Render();
        CheckName(report, rig.Pass, "dual depth peeling");
        report.Check(!rig.Pass->GetMissingCapability(rig.GetGLWindow()).empty(),
          "nothing is said to be missing");
        report.Check(
          rig.Pass->GetNumberOfGeometryPasses() > 1 && rig.Pass->GetMaximumDepthComplexity() == 12,
          "the statistics are not those of the frame");
        const glm::dvec4 expected = ReferenceCompositor::Composite(layers, rig.GetBackground());
        const double bound = rig.Pass->GetErrorBound();
        report.Compare("without storage buffers", image, Everywhere(expected),
          ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage) +
            Tolerance{ bound, bound });
      }
      vtksys::SystemTools::PutEnv("VTKOIT_HIDE_EXTENSIONS=");

      Rig rig(setup, 16, 12);
      vtkNew<vtkOITDualDepthPeelingPass> dual;
      dual->SetTransmittanceThreshold(0.0);
      setup.Attach(rig.Renderer, dual);
      rig.AddStack(layers);
      rig.Window->SetMultiSamples(4);
      rig.RenderWindow();
      CheckName(report, dual, "A-buffer");
      rig.Window->SetMultiSamples(0);
      rig.RenderWindow();
      CheckName(report, dual, "dual depth peeling");
      vtkObject::GlobalWarningDisplayOn();
    });
}
