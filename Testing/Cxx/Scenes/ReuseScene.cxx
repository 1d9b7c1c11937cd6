// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/ReuseScene.h"

#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkOITAutoPass.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

namespace vtkOITTest
{
namespace
{
void SetColor(vtkActor* actor, double r, double g, double b, double opacity)
{
  actor->GetProperty()->SetColor(r, g, b);
  actor->GetProperty()->SetOpacity(opacity);
}
}

//------------------------------------------------------------------------------
ReuseScene::ReuseScene(Rig& rig)
  : TheRig(rig)
  , Pass(vtkOITAutoPass::SafeDownCast(rig.Pass))
{
  vtkRenderer* renderer = rig.Renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(0.0, 0.5, 6.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(3.0, 12.0);

  this->BallSource->SetRadius(0.7);
  this->BallSource->SetThetaResolution(16);
  this->BallSource->SetPhiResolution(12);
  this->BallMapper->SetInputConnection(this->BallSource->GetOutputPort());
  this->Ball->SetMapper(this->BallMapper);
  this->Ball->SetPosition(-0.9, 0.2, 0.0);
  SetColor(this->Ball, 0.9, 0.4, 0.2, 0.5);
  this->Ball->GetProperty()->SetSpecular(0.4);
  // Of its own: VTK crashes when actors with and without properties of back faces share a mapper.
  vtkNew<vtkPolyDataMapper> secondMapper;
  secondMapper->SetInputConnection(this->BallSource->GetOutputPort());
  this->SecondBall->SetMapper(secondMapper);
  this->SecondBall->SetPosition(-0.5, 0.1, 0.4);
  SetColor(this->SecondBall, 0.2, 0.7, 0.3, 0.3);
  vtkNew<vtkProperty> inside;
  inside->SetColor(0.9, 0.9, 0.1);
  inside->SetOpacity(0.3);
  this->SecondBall->SetBackfaceProperty(inside);
  this->OpaqueBall->SetMapper(this->BallMapper);
  this->OpaqueBall->SetScale(0.5);
  this->OpaqueBall->SetPosition(-0.7, 0.0, 0.0);
  SetColor(this->OpaqueBall, 0.5, 0.5, 0.9, 1.0);

  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(2, 2);
  plane->Update();
  this->Table->DeepCopy(plane->GetOutput());
  for (const float value : { 0.1f, 0.4f, 0.6f, 0.9f })
  {
    this->TableValues->InsertNextValue(value);
  }
  this->Table->GetCellData()->SetScalars(this->TableValues);
  this->Colors->SetNumberOfTableValues(4);
  this->Colors->Build();
  for (int i = 0; i < 4; ++i)
  {
    this->Colors->SetTableValue(i, 0.2 + 0.2 * i, 0.8 - 0.2 * i, 0.5, 0.3 + 0.1 * i);
  }
  this->TableMapper->SetInputData(this->Table);
  this->TableMapper->SetLookupTable(this->Colors);
  this->TableMapper->SetScalarRange(0.0, 1.0);
  this->TableActor->SetMapper(this->TableMapper);
  this->TableActor->SetPosition(0.8, 0.6, 0.0);
  this->TableActor->GetProperty()->SetOpacity(0.8);

  this->TextureImage->SetDimensions(4, 4, 1);
  this->TextureImage->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* texels = static_cast<unsigned char*>(this->TextureImage->GetScalarPointer());
  for (int i = 0; i < 64; ++i)
  {
    texels[i] = static_cast<unsigned char>(60 + 37 * i % 180);
  }
  this->Texture->SetInputData(this->TextureImage);
  this->Texture->SetColorModeToDirectScalars();
  vtkNew<vtkPlaneSource> poster;
  vtkNew<vtkPolyDataMapper> posterMapper;
  posterMapper->SetInputConnection(poster->GetOutputPort());
  this->ClippingPlane->SetOrigin(-0.3, 0.0, 0.0);
  this->ClippingPlane->SetNormal(1.0, 0.2, 0.0);
  posterMapper->AddClippingPlane(this->ClippingPlane);
  this->Poster->SetMapper(posterMapper);
  this->Poster->SetTexture(this->Texture);
  this->Poster->SetPosition(0.4, -0.5, 0.5);
  this->Poster->GetProperty()->SetOpacity(0.9);
  this->Poster->ForceTranslucentOn();

  this->Lamp->SetLightTypeToSceneLight();
  this->Lamp->SetPosition(3.0, 4.0, 2.0);
  this->Lamp->SetIntensity(0.6);
  this->CameraLamp->SetLightTypeToCameraLight();
  this->CameraLamp->SetPosition(0.4, 0.4, 1.0);
  this->CameraLamp->PositionalOn();
  this->CameraLamp->SetConeAngle(12.0);
  this->CameraLamp->SetIntensity(0.4);
  this->Headlight->SetLightTypeToHeadlight();
  this->Headlight->SetIntensity(0.4);
  renderer->AutomaticLightCreationOff();
  for (vtkLight* light : { this->Lamp.Get(), this->CameraLamp.Get(), this->Headlight.Get() })
  {
    renderer->AddLight(light);
  }
  for (vtkActor* actor : { this->Ball.Get(), this->SecondBall.Get(), this->OpaqueBall.Get(),
         this->TableActor.Get(), this->Poster.Get() })
  {
    renderer->AddActor(actor);
  }
}

//------------------------------------------------------------------------------
ReuseScene::~ReuseScene() = default;
}
