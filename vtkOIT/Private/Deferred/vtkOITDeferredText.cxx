// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deferred/vtkOITDeferredText.h"

#include "Private/GL/vtkOITShaderText.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLightingMapPass.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace
{
constexpr const char* Lighting = "//VTK::Light::Impl";
constexpr const char* Declarations = "//VTK::Light::Dec";
constexpr const char* Mark = "//VTK::OIT::Light::Impl";
constexpr const char* Top = "//VTK::System::Dec";

/// As VTK names them.
constexpr const char* Kept = "oitAmbient = ambientColor;\n"
                             "  oitDiffuse = diffuseColor;\n"
                             "  oitSpecular = specularColor;\n"
                             "  oitPower = specularPower;\n"
                             "  oitNormal = normalVCVSOutput;\n"
                             "  gl_FragData[0] = vec4(1.0, 1.0, 1.0, opacity);\n";
constexpr const char* Unlit = "gl_FragData[0] = vec4(ambientColor + diffuseColor, opacity);\n";
constexpr const char* Variables = "#define OIT_CAPTURES\n"
                                  "vec3 oitAmbient = vec3(0.0);\n"
                                  "vec3 oitDiffuse = vec3(0.0);\n"
                                  "vec3 oitSpecular = vec3(0.0);\n"
                                  "vec3 oitNormal = vec3(0.0);\n"
                                  "float oitPower = 0.0;\n";

/// Those whose lighting is that of vtkOpenGLPolyDataMapper. Others may change it.
constexpr std::array<const char*, 5> KnownMappers = { "vtkOpenGLPolyDataMapper",
  "vtkCompositeMapperHelper2", "vtkOpenGLBatchedPolyDataMapper", "vtkOpenGLGlyph3DHelper",
  "vtkCompositePolyDataMapper2" };

/// Points and lines up to this size have, in VTK, at each pixel the position of it but for a pixel.
constexpr float ThinLine = 2.0f;

void Replace(std::string& text, const char* from, const std::string& to)
{
  const std::size_t at = text.find(from);
  if (at != std::string::npos)
  {
    text.replace(at, std::strlen(from), to);
  }
}

bool Has(const std::string& text, const char* what)
{
  return text.find(what) != std::string::npos;
}

/// Points and lines whose width matters to where they are.
bool HasWideParts(vtkAbstractMapper* mapper, vtkProperty* property)
{
  if (property->GetRenderPointsAsSpheres() || property->GetRenderLinesAsTubes())
  {
    return true;
  }
  if (property->GetPointSize() <= ThinLine && property->GetLineWidth() <= ThinLine)
  {
    return false;
  }
  auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return property->GetRepresentation() != VTK_SURFACE || property->GetVertexVisibility() || !mesh ||
    mesh->GetNumberOfVerts() > 0 || mesh->GetNumberOfLines() > 0;
}

bool ChangesShaders(vtkProp* prop)
{
  auto* shaders = vtkOpenGLShaderProperty::SafeDownCast(prop->GetShaderProperty());
  if (!shaders)
  {
    return false;
  }
  return shaders->HasFragmentShaderCode() || !shaders->GetAllShaderReplacements().empty();
}

bool HasOtherPasses(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys &&
    (keys->Length(vtkOpenGLRenderPass::RenderPasses()) > 1 ||
      keys->Has(vtkLightingMapPass::RENDER_NORMALS()) ||
      keys->Has(vtkLightingMapPass::RENDER_LUMINANCE()));
}
}

//------------------------------------------------------------------------------
bool vtkOITDeferredText::CanDefer(vtkAbstractMapper* mapper, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!mapper || !actor)
  {
    return false;
  }
  vtkProperty* property = actor->GetProperty();
  const bool isKnown = std::any_of(KnownMappers.begin(), KnownMappers.end(),
    [&](const char* name) { return std::strcmp(name, mapper->GetClassName()) == 0; });
  return isKnown && property->GetInterpolation() != VTK_PBR && !ChangesShaders(actor) &&
    !HasOtherPasses(actor) && !HasWideParts(mapper, property);
}

//------------------------------------------------------------------------------
bool vtkOITDeferredText::IsReflecting(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkProperty* back = actor ? actor->GetBackfaceProperty() : nullptr;
  return !actor || actor->GetProperty()->GetSpecular() > 0.0 || (back && back->GetSpecular() > 0.0);
}

//------------------------------------------------------------------------------
void vtkOITDeferredText::Before(
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) const
{
  if (CanDefer(mapper, prop))
  {
    Replace(fragmentShader, Lighting, Mark);
    Replace(fragmentShader, Declarations, "");
  }
}

//------------------------------------------------------------------------------
void vtkOITDeferredText::After(std::string& fragmentShader) const
{
  if (!Has(fragmentShader, Mark))
  {
    return;
  }
  const bool isLit = Has(fragmentShader, "float specularPower =") &&
    Has(fragmentShader, "normalVCVSOutput") && Has(fragmentShader, "vec3 specularColor =");
  Replace(fragmentShader, Mark, isLit ? Kept : Unlit);
  if (isLit)
  {
    Replace(fragmentShader, Top, std::string(Top) + "\n" + Variables);
  }
}
