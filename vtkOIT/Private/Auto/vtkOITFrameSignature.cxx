// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITFrameSignature.h"

#include "Private/Auto/vtkOITMeshShapes.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITPropInput.h"
#include "Private/Volume/vtkOITVolumes.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cstring>
#include <string>

namespace
{
/// Nothing but modification times of the actor's parts decides how it looks.
bool IsKnownProperty(vtkProperty* property)
{
  return !property || property->GetNumberOfTextures() == 0;
}

/// Other passes around this one change shaders, and transforms of texture coordinates are not part
/// of an actor's time.
bool HasPlainKeys(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return !keys ||
    (keys->Length(vtkOpenGLRenderPass::RenderPasses()) <= 0 &&
      !keys->Has(vtkOITGeneralTextureTransform()));
}

/// Where more time is allowed than any frame takes, mappers take the same samples in each.
constexpr double LongerThanAnyFrame = 100.0; // s

/// One input, VTK's shader, and samples that do not depend on how long the last frame took.
bool IsPlainVolume(vtkVolume* volume, vtkGPUVolumeRayCastMapper* mapper)
{
  vtkShaderProperty* shader = volume->GetShaderProperty();
  return volume->GetClassName() == std::string("vtkVolume") && HasPlainKeys(volume) &&
    mapper->GetClassName() == std::string("vtkOpenGLGPUVolumeRayCastMapper") &&
    mapper->GetInputCount() == 1 && shader->GetNumberOfShaderReplacements() == 0 &&
    !shader->HasVertexShaderCode() && !shader->HasFragmentShaderCode() &&
    !mapper->HasObserver(vtkCommand::UpdateShaderEvent) &&
    !volume->GetMapper()->HasObserver(vtkCommand::UpdateShaderEvent) &&
    (!mapper->GetAutoAdjustSampleDistances() ||
      volume->GetAllocatedRenderTime() > LongerThanAnyFrame);
}

/// Nothing draws into it but its input.
bool IsKnownTexture(vtkTexture* texture)
{
  return !texture || (texture->GetInput() && !texture->GetCubeMap());
}
}

//------------------------------------------------------------------------------
vtkOITFrameSignature::vtkOITFrameSignature(const vtkOITFrame& frame, vtkMTimeType settings)
{
  vtkRenderer* renderer = frame.Renderer;
  this->Known = !frame.Window->GetStereoRender() && !renderer->GetUseShadows() &&
    !renderer->GetUseImageBasedLighting() && frame.Target.Samples == 0;
  this->Add(settings);
  this->AddView(frame);
  this->AddLights(frame);
  this->AddProps(frame);
  if (frame.Volumes)
  {
    for (vtkProp* prop : frame.Volumes->GetBetween())
    {
      this->AddVolume(prop);
    }
  }
}

//------------------------------------------------------------------------------
void vtkOITFrameSignature::AddDoubles(const double* values, int count)
{
  for (int i = 0; i < count; ++i)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &values[i], sizeof(bits));
    this->Add(bits);
  }
}

//------------------------------------------------------------------------------
void vtkOITFrameSignature::AddView(const vtkOITFrame& frame)
{
  vtkRenderer* renderer = frame.Renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Add(frame.Window);
  this->Add(renderer);
  this->AddDoubles(camera->GetModelViewTransformMatrix()->GetData(), 16);
  this->AddDoubles(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)->GetData(),
    16);
  this->Add(camera->GetParallelProjection());
  this->AddDoubles(frame.Window->GetTileViewport(), 4);
  for (const vtkOITRectangle& r : { frame.Viewport, frame.Rectangle })
  {
    for (const int number : { r.X, r.Y, r.Width, r.Height })
    {
      this->Add(static_cast<std::uint64_t>(number));
    }
  }
  this->Add(frame.Target.Framebuffer);
  this->Add(frame.Target.DrawBuffers[0]);
  this->Add(frame.Target.DepthBits);
  this->Add(frame.Target.ClampsColor);
  this->Add(frame.Window->GetPointSmoothing());
  this->Add(frame.Window->GetLineSmoothing());
  this->Add(frame.Window->GetPolygonSmoothing());
}

//------------------------------------------------------------------------------
void vtkOITFrameSignature::AddLights(const vtkOITFrame& frame)
{
  vtkRenderer* renderer = frame.Renderer;
  this->Add(renderer->GetTwoSidedLighting());
  this->AddDoubles(renderer->GetAmbient(), 3);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    // Values, not the time of modification: the renderer moves lights with the camera.
    this->Add(light);
    this->Add(light->GetLightType());
    this->Add(light->GetSwitch());
    this->Add(light->GetPositional());
    this->AddDoubles(light->GetDiffuseColor(), 3);
    this->AddDoubles(light->GetSpecularColor(), 3);
    this->AddDoubles(light->GetAmbientColor(), 3);
    this->AddDoubles(light->GetAttenuationValues(), 3);
    double position[3];
    double focalPoint[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focalPoint);
    this->AddDoubles(position, 3);
    this->AddDoubles(focalPoint, 3);
    const double numbers[] = { light->GetIntensity(), light->GetConeAngle(), light->GetExponent() };
    this->AddDoubles(numbers, 3);
  }
}

//------------------------------------------------------------------------------
void vtkOITFrameSignature::AddProps(const vtkOITFrame& frame)
{
  double factor = 0.0;
  double units = 0.0;
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(factor, units);
  const double parameters[] = { factor, units, vtkMapper::GetResolveCoincidentTopologyZShift() };
  this->AddDoubles(parameters, 3);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(factor, units);
  double pointUnits = 0.0;
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(pointUnits);
  const double others[] = { factor, units, pointUnits };
  this->AddDoubles(others, 3);
  this->Add(vtkMapper::GetResolveCoincidentTopology());
  this->Add(vtkMapper::GetResolveCoincidentTopologyPolygonOffsetFaces());
  for (vtkProp* prop : frame.Props)
  {
    vtkActor* plain = vtkOITFindPlainActor(prop);
    vtkActor* actor = plain ? plain : vtkOITFindCompositeActor(prop);
    if (!actor || actor->GetMapper()->HasObserver(vtkCommand::UpdateShaderEvent) ||
      actor->HasObserver(vtkCommand::UpdateShaderEvent) || !IsKnownProperty(actor->GetProperty()) ||
      !IsKnownProperty(actor->GetBackfaceProperty()) || !HasPlainKeys(actor) ||
      !IsKnownTexture(actor->GetTexture()) || vtkOITDrawsSelection(actor->GetMapper(), 0))
    {
      this->Known = false;
      return;
    }
    this->Add(prop);
    this->Add(vtkOITGetRedrawMTime(actor));
    this->AddDoubles(actor->GetMatrix()->GetData(), 16);
    if (vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes())
    {
      for (int i = 0; i < planes->GetNumberOfItems(); ++i)
      {
        this->Add(planes->GetItem(i)->GetMTime());
      }
    }
    if (vtkTexture* texture = actor->GetTexture())
    {
      texture->Update();
      this->Add(texture->GetMTime());
      this->Add(texture->GetInput()->GetMTime());
      this->Add(texture->GetLookupTable() ? texture->GetLookupTable()->GetMTime() : 0);
    }
    if (!plain)
    {
      this->AddBlocks(actor->GetMapper());
    }
  }
}

//------------------------------------------------------------------------------
// Not by GetRedrawMTime(): that gives the property a gradient opacity of 1, with which mappers compute
// gradients at each sample.
void vtkOITFrameSignature::AddVolume(vtkProp* prop)
{
  auto* volume = vtkVolume::SafeDownCast(prop);
  vtkGPUVolumeRayCastMapper* mapper = volume ? vtkOITFindGPUMapper(volume) : nullptr;
  if (!mapper || !IsPlainVolume(volume, mapper))
  {
    this->Known = false;
    return;
  }
  if (vtkAlgorithm* input = volume->GetMapper()->GetInputAlgorithm())
  {
    input->Update();
  }
  vtkVolumeProperty* property = volume->GetProperty();
  this->Add(prop);
  this->Add(volume->GetMTime());
  this->Add(property);
  this->Add(property->GetMTime());
  this->Add(volume->GetMapper());
  this->Add(volume->GetMapper()->GetMTime());
  this->Add(mapper->GetMTime());
  this->AddDoubles(volume->GetMatrix()->GetData(), 16);
  const auto addTime = [this](vtkObject* object) { this->Add(object ? object->GetMTime() : 0); };
  addTime(volume->GetMapper()->GetDataSetInput());
  addTime(mapper->GetMaskInput());
  for (int i = 0; i < VTK_MAX_VRCOMP; ++i)
  {
    addTime(property->GetTransferFunction2D(i));
  }
  for (const int label : property->GetLabelMapLabels())
  {
    this->Add(static_cast<std::uint64_t>(label));
    addTime(property->GetLabelColor(label));
    addTime(property->GetLabelScalarOpacity(label));
    addTime(property->GetLabelGradientOpacity(label));
  }
  if (vtkPlaneCollection* planes = volume->GetMapper()->GetClippingPlanes())
  {
    for (int i = 0; i < planes->GetNumberOfItems(); ++i)
    {
      this->Add(planes->GetItem(i)->GetMTime());
    }
  }
}

//------------------------------------------------------------------------------
// The pipeline is up to date: the mapper was asked whether it is translucent.
void vtkOITFrameSignature::AddBlocks(vtkMapper* mapper)
{
  auto* withAttributes = vtkOITCompositeMapper::SafeDownCast(mapper);
  vtkCompositeDataDisplayAttributes* attributes =
    withAttributes ? withAttributes->GetCompositeDataDisplayAttributes() : nullptr;
  if (attributes)
  {
    this->Add(attributes);
    this->Add(attributes->GetMTime());
    this->Known =
      this->Known && !vtkOITHasBlockTables(attributes, 0) && !vtkOITHasBlockTextures(attributes, 0);
  }
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  this->Add(data);
  this->Add(data ? data->GetMTime() : 0);
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    return;
  }
  const auto it = vtk::TakeSmartPointer(blocks->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    this->Add(it->GetCurrentFlatIndex());
    this->Add(it->GetCurrentDataObject());
    this->Add(it->GetCurrentDataObject()->GetMTime());
  }
}
