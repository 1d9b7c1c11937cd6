// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/LitScenes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace vtkOITTest
{
namespace
{
vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.5);
  source->SetThetaResolution(20);
  source->SetPhiResolution(14);
  source->Update();
  vtkSmartPointer<vtkPolyData> mesh = source->GetOutput();
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("heights");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    coordinates->InsertNextTuple2(p[0] + 0.5, p[1] + 0.5);
    heights->InsertNextValue(static_cast<float>(p[2]));
    colors->InsertNextTuple4(
      40 + 400 * std::abs(p[0]), 40 + 400 * std::abs(p[1]), 90, 60 + 300 * std::abs(p[2]));
  }
  mesh->GetPointData()->SetTCoords(coordinates);
  mesh->GetPointData()->AddArray(heights);
  mesh->GetPointData()->AddArray(colors);
  vtkNew<vtkFloatArray> numbers;
  numbers->SetName("numbers");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<float>(i % 7));
  }
  mesh->GetCellData()->AddArray(numbers);
  return mesh;
}

void ShowArray(vtkActor* actor, const char* name, bool isOfCells)
{
  vtkMapper* mapper = actor->GetMapper();
  mapper->SetScalarVisibility(true);
  mapper->SetScalarMode(
    isOfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectColorArray(name);
  mapper->SetScalarRange(isOfCells ? 0.0 : -0.5, isOfCells ? 6.0 : 0.5);
}

void AddTexture(vtkActor* actor, int components)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 16 * components; ++i)
  {
    texel[i] = static_cast<unsigned char>(55 + (i * 67) % 200);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  actor->SetTexture(texture);
}

vtkSmartPointer<vtkTexture> MakeTexture(int first, int range, bool isSRGB)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 48; ++i)
  {
    texel[i] = static_cast<unsigned char>(first + (i * 67) % range);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->SetUseSRGBColorSpace(isSRGB);
  return texture;
}

void MakePhysical(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPBR();
  property->SetMetallic(0.4);
  property->SetRoughness(0.3);
}

void AddPhysicalTextures(vtkActor* actor, vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> tangents;
  tangents->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    tangents->InsertNextTuple3(1.0, 0.0, 0.0);
  }
  mesh->GetPointData()->SetTangents(tangents);
  vtkProperty* property = actor->GetProperty();
  property->SetBaseColorTexture(MakeTexture(55, 200, true));
  property->SetORMTexture(MakeTexture(90, 150, false));
  property->SetEmissiveTexture(MakeTexture(10, 60, true));
  property->SetNormalTexture(MakeTexture(140, 60, false));
  property->SetOcclusionStrength(0.7);
}

void MakeShiny(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  property->SetAmbient(0.15);
  property->SetAmbientColor(0.9, 0.2, 0.4);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.7);
  property->SetSpecularColor(0.9, 1.0, 0.6);
  property->SetSpecularPower(25.0);
}

}

//------------------------------------------------------------------------------
const std::vector<LitMaterial>& GetLitMaterials()
{
  static const std::vector<LitMaterial> materials = {
    { "shiny", [](vtkActor* a, vtkPolyData*) { MakeShiny(a); } },
    { "dull", [](vtkActor*, vtkPolyData*) {} },
    { "flat",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        a->GetProperty()->SetInterpolationToFlat();
      } },
    { "without normals",
      [](vtkActor* a, vtkPolyData* mesh)
      {
        MakeShiny(a);
        mesh->GetPointData()->SetNormals(nullptr);
      } },
    { "unlit", [](vtkActor* a, vtkPolyData*) { a->GetProperty()->LightingOff(); } },
    { "with a back",
      [](vtkActor* a, vtkPolyData*)
      {
        vtkNew<vtkProperty> back;
        back->SetColor(0.1, 0.9, 0.3);
        back->SetSpecular(0.5);
        back->SetSpecularPower(8.0);
        back->SetOpacity(0.7);
        a->SetBackfaceProperty(back);
      } },
    { "with colours",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        ShowArray(a, "colors", false);
        a->GetMapper()->SetColorModeToDirectScalars();
      } },
    { "with mapped scalars", [](vtkActor* a, vtkPolyData*) { ShowArray(a, "heights", false); } },
    { "with scalars mapped later",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        ShowArray(a, "heights", false);
        a->GetMapper()->SetInterpolateScalarsBeforeMapping(true);
      } },
    { "with scalars of cells", [](vtkActor* a, vtkPolyData*) { ShowArray(a, "numbers", true); } },
    { "textured",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        AddTexture(a, 3);
      } },
    { "textured with alpha", [](vtkActor* a, vtkPolyData*) { AddTexture(a, 4); } },
    { "with edges",
      [](vtkActor* a, vtkPolyData*)
      {
        a->GetProperty()->EdgeVisibilityOn();
        a->GetProperty()->SetEdgeColor(0.9, 0.9, 0.1);
      } },
    { "wireframe",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        a->GetProperty()->SetRepresentationToWireframe();
      } },
    { "of wide lines",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        a->GetProperty()->SetRepresentationToWireframe();
        a->GetProperty()->SetLineWidth(5.0f);
      } },
    { "of points",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        a->GetProperty()->SetRepresentationToPoints();
        a->GetProperty()->SetPointSize(6.0f);
      } },
    { "of spheres",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        a->GetProperty()->SetRepresentationToPoints();
        a->GetProperty()->SetPointSize(8.0f);
        a->GetProperty()->SetRenderPointsAsSpheres(true);
      } },
    { "physically based", [](vtkActor* a, vtkPolyData*) { MakePhysical(a); } },
    { "physically based and polished",
      [](vtkActor* a, vtkPolyData*)
      {
        MakePhysical(a);
        a->GetProperty()->SetMetallic(1.0);
        a->GetProperty()->SetRoughness(0.2);
      } },
    { "physically based with textures",
      [](vtkActor* a, vtkPolyData* mesh)
      {
        MakePhysical(a);
        AddPhysicalTextures(a, mesh);
      } },
    { "physically based with colours",
      [](vtkActor* a, vtkPolyData*)
      {
        MakePhysical(a);
        ShowArray(a, "colors", false);
        a->GetMapper()->SetColorModeToDirectScalars();
      } },
    { "physically based and anisotropic",
      [](vtkActor* a, vtkPolyData* mesh)
      {
        MakePhysical(a);
        AddPhysicalTextures(a, mesh);
        a->GetProperty()->SetAnisotropy(0.6);
      } },
    { "physically based under a clear coat",
      [](vtkActor* a, vtkPolyData*)
      {
        MakePhysical(a);
        a->GetProperty()->SetCoatStrength(0.8);
        a->GetProperty()->SetCoatRoughness(0.2);
      } },
    { "physically based with tinted edges",
      [](vtkActor* a, vtkPolyData*)
      {
        MakePhysical(a);
        a->GetProperty()->SetEdgeTint(1.0, 0.6, 0.2);
      } },
    { "with a shader replacement",
      [](vtkActor* a, vtkPolyData*)
      {
        MakeShiny(a);
        a->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
          "//VTK::Light::Impl\n  gl_FragData[0].rgb = gl_FragData[0].bgr;\n", false);
      } },
  };
  return materials;
}

//------------------------------------------------------------------------------
void AddLitScene(vtkRenderer* renderer, const LitMaterial& material)
{
  for (int i = 0; i < 3; ++i)
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeSphere();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0.3 * i - 0.3, 0.1 * i, 0.15 * i - 0.1);
    actor->SetScale(1.0, i == 2 ? 0.4 : 1.0, 1.0);
    actor->RotateX(25.0 * i);
    actor->GetProperty()->SetColor(0.9 - 0.3 * i, 0.5, 0.2 + 0.3 * i);
    actor->GetProperty()->SetOpacity(0.35 + 0.2 * i);
    material.Apply(actor, mesh);
    actor->ForceTranslucentOn();
    renderer->AddActor(actor);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(0.4, 0.5, 2.6);
  camera->SetFocalPoint(0.0, 0.05, 0.0);
  camera->SetViewAngle(30.0);
  camera->SetClippingRange(0.5, 6.0);
}
}
