// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Volume/vtkOITVolumes.h"

#include "Private/Engine/vtkOITPartState.h"
#include "Private/Volume/vtkOITVolumeGather.h"
#include "Private/Volume/vtkOITVolumeHook.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderPass.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
/// Opens what the mappers have for classes derived from them.
struct GPUMapper : public vtkGPUVolumeRayCastMapper
{
  static float& ImageDistance(vtkGPUVolumeRayCastMapper* mapper)
  {
    return mapper->*(&GPUMapper::ImageSampleDistance);
  }
};
struct SmartMapper : public vtkSmartVolumeMapper
{
  static vtkGPUVolumeRayCastMapper* GetGPUMapper(vtkSmartVolumeMapper* mapper)
  {
    return mapper->*(&SmartMapper::GPUMapper);
  }
};

/// `collection`: an empty one, and empty again afterwards.
std::vector<vtkVolume*> GetVolumes(vtkProp* prop, vtkPropCollection* collection)
{
  std::vector<vtkVolume*> volumes;
  prop->GetVolumes(collection);
  if (collection->GetNumberOfItems() == 0)
  {
    return volumes;
  }
  vtkCollectionSimpleIterator it;
  collection->InitTraversal(it);
  while (vtkProp* part = collection->GetNextProp(it))
  {
    auto* volume = vtkVolume::SafeDownCast(part);
    if (volume && volume->GetVisibility() && volume->GetMapper())
    {
      volumes.push_back(volume);
    }
  }
  collection->RemoveAllItems();
  return volumes;
}

std::vector<vtkVolume*> GetVolumes(vtkProp* prop)
{
  return GetVolumes(prop, vtkNew<vtkPropCollection>());
}

bool IsDrawnByGPU(vtkVolume* volume)
{
  auto* smart = vtkSmartVolumeMapper::SafeDownCast(volume->GetMapper());
  if (!smart)
  {
    return vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper()) ||
      volume->GetMapper()->IsA("vtkMultiBlockVolumeMapper");
  }
  const int requested = smart->GetRequestedRenderMode();
  // Where there is no GPU, it draws by the CPU, and says so once it has drawn.
  return (requested == vtkSmartVolumeMapper::DefaultRenderMode ||
           requested == vtkSmartVolumeMapper::GPURenderMode) &&
    smart->GetLastUsedRenderMode() != vtkSmartVolumeMapper::RayCastRenderMode;
}

/// Volumes that mappers draw into pictures of their own are not.
bool HasVolumesOnScreen(vtkProp* prop, vtkPropCollection* collection)
{
  const std::vector<vtkVolume*> volumes = GetVolumes(prop, collection);
  return std::any_of(volumes.begin(), volumes.end(),
    [](vtkVolume* volume)
    {
      vtkGPUVolumeRayCastMapper* mapper = vtkOITFindGPUMapper(volume);
      return !mapper || !mapper->GetRenderToImage();
    });
}

/// While one lives, each pixel has a ray of its own (ImageSampleDistance): the reduced picture would
/// blur meshes. Not by the setters, which would make mappers compile their programs anew.
class RayForEachPixel
{
public:
  explicit RayForEachPixel(vtkProp* prop)
  {
    for (vtkVolume* volume : GetVolumes(prop))
    {
      if (vtkGPUVolumeRayCastMapper* mapper = vtkOITFindGPUMapper(volume))
      {
        this->Before.emplace_back(mapper, mapper->GetImageSampleDistance());
        GPUMapper::ImageDistance(mapper) = 1.0f;
      }
    }
  }
  ~RayForEachPixel()
  {
    for (const auto& before : this->Before)
    {
      GPUMapper::ImageDistance(before.first) = before.second;
    }
  }
  RayForEachPixel(const RayForEachPixel&) = delete;
  RayForEachPixel& operator=(const RayForEachPixel&) = delete;

private:
  std::vector<std::pair<vtkGPUVolumeRayCastMapper*, float>> Before;
};
}

//------------------------------------------------------------------------------
vtkGPUVolumeRayCastMapper* vtkOITFindGPUMapper(vtkVolume* volume)
{
  auto* smart = vtkSmartVolumeMapper::SafeDownCast(volume->GetMapper());
  return smart ? SmartMapper::GetGPUMapper(smart)
               : vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
}

//------------------------------------------------------------------------------
vtkOITVolumes::vtkOITVolumes(vtkRenderPass* pass, const vtkRenderState* state)
  : Pass(pass)
  , State(state)
{
  // Most frames have many props, and no volumes: one collection for all of them.
  vtkNew<vtkPropCollection> collection;
  this->All = vtkOITFindDrawnProps(
    state, [&](vtkProp* prop) { return HasVolumesOnScreen(prop, collection); });
  this->After = this->All;
}

//------------------------------------------------------------------------------
void vtkOITVolumes::SetOrder(
  std::vector<vtkProp*> before, std::vector<vtkProp*> between, std::vector<vtkProp*> after)
{
  this->Before = std::move(before);
  this->Between = std::move(between);
  this->After = std::move(after);
}

//------------------------------------------------------------------------------
bool vtkOITVolumes::IsAlone() const
{
  return this->Between.size() == 1 && vtkVolume::SafeDownCast(this->Between.front()) &&
    vtkOITFindGPUMapper(vtkVolume::SafeDownCast(this->Between.front()));
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITVolumes::Draw(vtkOITVolumeGather& gather)
{
  this->Failed.clear();
  vtkOITFailure first;
  for (vtkProp* prop : this->Between)
  {
    const RayForEachPixel rays(prop);
    const vtkOITPartState state(this->State, { prop });
    if (vtkOITFailure failure = gather.GetHook()->RenderBy(this->Pass, state.Get()))
    {
      this->Failed.push_back(prop);
      first = first ? first : failure;
    }
    else if (this->Pass->GetNumberOfRenderedProps() > 0)
    {
      this->Rendered.insert(prop);
    }
  }
  return first;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITVolumes::Refuse(const std::string& reason)
{
  this->Failed = this->Between;
  return vtkOITFailure(reason);
}

//------------------------------------------------------------------------------
void vtkOITVolumes::DrawPlainly(const std::vector<vtkProp*>& props)
{
  if (!props.empty() && this->Pass)
  {
    this->Pass->Render(vtkOITPartState(this->State, props).Get());
    if (this->Pass->GetNumberOfRenderedProps() > 0)
    {
      this->Rendered.insert(props.begin(), props.end());
    }
  }
}

//------------------------------------------------------------------------------
void vtkOITVolumes::DrawAfter()
{
  this->DrawPlainly(this->After);
  if (this->Pass)
  {
    const std::set<vtkProp*> volumes(this->All.begin(), this->All.end());
    std::vector<vtkProp*> others;
    vtkProp** first = this->State->GetPropArray();
    std::copy_if(first, first + this->State->GetPropArrayCount(), std::back_inserter(others),
      [&](vtkProp* prop) { return volumes.count(prop) == 0; });
    this->Pass->Render(vtkOITPartState(this->State, others).Get());
    this->RenderedOthers = this->Pass->GetNumberOfRenderedProps();
  }
}

//------------------------------------------------------------------------------
bool vtkOITIsHookedVolume(vtkProp* prop)
{
  const std::vector<vtkVolume*> volumes = GetVolumes(prop);
  return vtkVolume::SafeDownCast(prop) && std::all_of(volumes.begin(), volumes.end(), IsDrawnByGPU);
}
