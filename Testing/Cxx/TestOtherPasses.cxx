// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Another pass around ours changes the shaders of the props, as vtkSSAOPass does: it writes further
// outputs, declares one of its own, doubles the colours, and draws into other buffers before each
// draw. Colours above 1 are kept in float framebuffers and clamped in fixed-point ones, as OpenGL
// does before it blends.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkShaderProgram.h"

#include <glm/common.hpp>

using namespace vtkOITTest;

namespace
{
class OtherPass : public vtkOpenGLRenderPass
{
public:
  static OtherPass* New();
  vtkTypeMacro(OtherPass, vtkOpenGLRenderPass);

  void Render(const vtkRenderState*) override {}

  bool PreReplaceShaderValues(
    std::string&, std::string&, std::string& shader, vtkAbstractMapper*, vtkProp*) override
  {
    vtkShaderProgram::Substitute(
      shader, "//VTK::Light::Dec", "//VTK::Light::Dec\nout vec4 otherOutput;\n");
    return vtkShaderProgram::Substitute(shader, "//VTK::Light::Impl",
      "//VTK::Light::Impl\n  gl_FragData[0].rgb *= 2.0;\n  gl_FragData[1] = vec4(0.5);\n"
      "  gl_FragData[2] = gl_FragData[1];\n  otherOutput = vec4(0.25);\n");
  }

  bool SetShaderParameters(
    vtkShaderProgram*, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*) override
  {
    ++this->NumberOfDraws;
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    return true;
  }

  int NumberOfDraws = 0;

protected:
  OtherPass() = default;
  ~OtherPass() override = default;
};
vtkStandardNewMacro(OtherPass);

void PutAround(OtherPass* pass, vtkProp* prop)
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkOpenGLRenderPass::RenderPasses(), pass, 0); // Append() leaks in VTK 9.1
  prop->SetPropertyKeys(keys);
}
}

int TestOtherPasses(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 16, 12);
      // Doubled: within [0, 1], and beyond.
      const std::vector<Layer> layers{ { 0.25f, { 0.75f, 0.125f, 0.5f, 0.5f } },
        { 0.5f, { 0.25f, 0.875f, 0.375f, 0.25f } }, { 0.75f, { 0.125f, 0.25f, 1.0f, 0.75f } } };
      std::vector<Layer> doubled = layers;
      std::vector<Layer> clamped = layers;
      vtkNew<OtherPass> other;
      for (std::size_t i = 0; i < layers.size(); ++i)
      {
        PutAround(other, rig.AddQuad(layers[i]));
        const glm::vec3 color = 2.0f * glm::vec3(layers[i].Color);
        doubled[i].Color = glm::vec4(color, layers[i].Color.a);
        clamped[i].Color = glm::vec4(glm::min(color, glm::vec3(1.0f)), layers[i].Color.a);
      }
      const glm::dvec4 background = rig.GetBackground();
      for (int frame = 0; frame < 3; ++frame)
      {
        report.Compare("doubled", rig.Render(),
          Everywhere(ReferenceCompositor::Composite(doubled, background)),
          ReferenceCompositor::RoundingBound(doubled, background, setup.FragmentStorage));
        report.Check(rig.Pass->GetExact(), "doubled: not exact");
      }
      rig.RenderWindow();
      report.Compare("doubled, in 8 bits", rig.RenderWindow(),
        Everywhere(ReferenceCompositor::Composite(clamped, background)), Rig::WindowTolerance());
      report.Check(other->NumberOfDraws > 0, "the other pass was not asked");
    });
}
