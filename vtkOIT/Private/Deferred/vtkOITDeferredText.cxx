// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deferred/vtkOITDeferredText.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITIsCalled.h"
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
#include <sstream>

namespace
{
constexpr const char* Lighting = "//VTK::Light::Impl";
constexpr const char* Declarations = "//VTK::Light::Dec";
constexpr const char* Mark = "//VTK::OIT::Light::Impl";
constexpr const char* PhysicalMark = "//VTK::OIT::Light::Physical";
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

/// Of physically based rendering, whose text VTK puts in the place of the mark: from the first of these
/// on it is about lights, the others are in front of it, and the last one tells that nothing is lit by
/// an image.
constexpr const char* PhysicalLighting = "vec3 L, H, radiance";
constexpr std::array<const char*, 4> PhysicalNames = {
  "vec3 albedo =", "vec3 N =", "float f90 =", "vec3 irradiance = vec3(0.0);"
};
/// Where VTK has directional lights beside positional ones come from where they do.
constexpr const char* Positional = "lightPositional";
constexpr const char* OwnDirection = "L = -lightDirectionVC";
constexpr const char* PhysicalKept = "oitAmbient = emissiveColor;\n"
                                     "  oitDiffuse = (1.0 - metallic) * recPI * albedo;\n"
                                     "  oitSpecular = F0;\n"
                                     "  oitPower = roughness;\n"
                                     "  oitNormal = N;\n"
                                     "  oitOcclusion = mix(1.0, ao, aoStrengthUniform);\n"
                                     "  oitGrazing = mix(f90, 1.0, metallic);\n"
                                     "  gl_FragData[0] = vec4(1.0, 1.0, 1.0, opacity);\n";
constexpr const char* PhysicalVariables = "#define OIT_CAPTURES_PHYSICAL\n"
                                          "float oitOcclusion = 1.0;\n"
                                          "float oitGrazing = 1.0;\n";

/// Textures that are read before the lighting.
constexpr std::array<const char*, 4> PhysicalTextures = { "albedoTex", "materialTex", "normalTex",
  "emissiveTex" };

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

/// Physically based rendering that is more than what is kept of it, or that VTK multiplies with textures behind
/// it.
bool IsTooPhysical(vtkAbstractMapper* mapper, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  auto* scalars = vtkMapper::SafeDownCast(mapper);
  const double* tint = property->GetEdgeTint();
  const auto& textures = property->GetAllTextures();
  const bool hasOthers = std::any_of(textures.begin(), textures.end(),
    [](const auto& texture)
    {
      return std::find(PhysicalTextures.begin(), PhysicalTextures.end(), texture.first) ==
        PhysicalTextures.end();
    });
  return property->GetAnisotropy() != 0.0 || property->GetCoatStrength() != 0.0 || tint[0] != 1.0 ||
    tint[1] != 1.0 || tint[2] != 1.0 || hasOthers || actor->GetTexture() ||
    actor->GetBackfaceProperty() || !scalars ||
    (scalars->GetScalarVisibility() && scalars->GetInterpolateScalarsBeforeMapping());
}

/// Uniforms of lights, of which there are as many as lights, and empty lines, which depend on their kind.
void RemoveLights(std::string& text)
{
  constexpr std::array<const char*, 7> uniforms = { "vec3 lightColor", "vec3 lightDirectionVC",
    "vec3 lightPositionVC", "vec3 lightAttenuation", "float lightConeAngle", "float lightExponent",
    "int lightPositional" };
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
  {
    const bool isOfLight = std::any_of(uniforms.begin(), uniforms.end(),
      [&](const char* uniform) { return Has(line, (std::string("uniform ") + uniform).c_str()); });
    if (!isOfLight && line.find_first_not_of(" \t\r") != std::string::npos)
    {
      kept += line + '\n';
    }
  }
  text = kept;
}

/// False for what is not as it is known; then nothing is changed.
bool KeepPhysical(std::string& text)
{
  const std::size_t from = text.find(PhysicalLighting);
  const std::size_t mark = text.find(PhysicalMark);
  const bool isKnown = std::all_of(PhysicalNames.begin(), PhysicalNames.end(),
    [&](const char* name) { return text.find(name) < from; });
  if (!isKnown || from == std::string::npos || mark == std::string::npos || mark < from)
  {
    return false;
  }
  const std::string lighting = text.substr(from, mark - from);
  const bool hasOwnDirection = Has(lighting, OwnDirection);
  if (Has(lighting, Positional) && hasOwnDirection == vtkOITDirectionalFromPosition)
  {
    return false; // of a version whose directional lights are not as they are known
  }
  text.replace(from, mark - from, PhysicalKept);
  RemoveLights(text);
  return true;
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
bool vtkOITDeferredText::CanDefer(vtkAbstractMapper* mapper, vtkProp* prop) const
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!mapper || !actor)
  {
    return false;
  }
  vtkProperty* property = actor->GetProperty();
  const bool isKnown = vtkOITIsCalledOneOf(mapper, KnownMappers);
  const bool isHard = IsPhysical(actor) && !(this->TakesPhysical && !IsTooPhysical(mapper, actor));
  return isKnown && !isHard && !ChangesShaders(actor) && !HasOtherPasses(actor) &&
    !HasWideParts(mapper, property);
}

//------------------------------------------------------------------------------
bool vtkOITDeferredText::IsReflecting(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkProperty* back = actor ? actor->GetBackfaceProperty() : nullptr;
  return !actor || actor->GetProperty()->GetSpecular() > 0.0 || (back && back->GetSpecular() > 0.0);
}

//------------------------------------------------------------------------------
bool vtkOITDeferredText::IsPhysical(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetProperty()->GetInterpolation() == VTK_PBR &&
    actor->GetProperty()->GetLighting();
}

//------------------------------------------------------------------------------
void vtkOITDeferredText::Before(
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) const
{
  if (!this->CanDefer(mapper, prop))
  {
    return;
  }
  if (IsPhysical(prop))
  {
    Replace(fragmentShader, Lighting, std::string(Lighting) + "\n  " + PhysicalMark + "\n");
  }
  else
  {
    Replace(fragmentShader, Lighting, Mark);
    Replace(fragmentShader, Declarations, "");
  }
}

//------------------------------------------------------------------------------
void vtkOITDeferredText::After(std::string& fragmentShader) const
{
  if (Has(fragmentShader, PhysicalMark) && KeepPhysical(fragmentShader))
  {
    Replace(fragmentShader, Top, std::string(Top) + "\n" + Variables + PhysicalVariables);
  }
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
