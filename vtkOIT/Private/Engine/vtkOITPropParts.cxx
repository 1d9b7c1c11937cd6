// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Engine/vtkOITPropParts.h"

#include "Private/Frame/vtkOITIsCalled.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <array>
#include <set>

//------------------------------------------------------------------------------
bool vtkOITIsSimpleActor(vtkProp* prop)
{
  static constexpr std::array<const char*, 11> names = { "vtkOpenGLPolyDataMapper",
    "vtkDataSetMapper", "vtkCompositePolyDataMapper", "vtkCompositePolyDataMapper2",
    "vtkOpenGLGlyph3DMapper", "vtkOpenGLSphereMapper", "vtkOpenGLStickMapper",
    "vtkOpenGLPointGaussianMapper", "vtkOpenGLHyperTreeGridMapper",
    "vtkOpenGLSurfaceProbeVolumeMapper", "vtkOpenGLLowMemoryPolyDataMapper" };
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  return mapper && vtkOITIsCalled(actor, "vtkOpenGLActor") &&
    std::any_of(
      names.begin(), names.end(), [mapper](const char* name) { return mapper->IsA(name) != 0; });
}

//------------------------------------------------------------------------------
bool vtkOITAddsLight(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* gaussians = actor ? vtkPointGaussianMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return gaussians && gaussians->GetEmissive();
}

//------------------------------------------------------------------------------
bool vtkOITDrawsInOrder(const std::vector<vtkProp*>& props)
{
  static constexpr std::array<const char*, 5> names = { "vtkOpenGLPolyDataMapper",
    "vtkDataSetMapper", "vtkOpenGLSphereMapper", "vtkOpenGLStickMapper",
    "vtkOpenGLPointGaussianMapper" };
  return std::all_of(props.begin(), props.end(),
    [](vtkProp* prop)
    {
      auto* actor = vtkActor::SafeDownCast(prop);
      vtkMapper* mapper = actor && vtkOITIsSimpleActor(prop) ? actor->GetMapper() : nullptr;
      return vtkOITIsCalledOneOf(mapper, names);
    });
}

//------------------------------------------------------------------------------
// Assemblies inside of a prop are found as consumers of their parts: they replace the keys of these
// by their own. Parts share the keys of a prop that hands them on, and need no others then.
std::vector<vtkProp*> vtkOITFindParts(const std::vector<vtkProp*>& props)
{
  std::vector<vtkProp*> found;
  for (vtkProp* prop : props)
  {
    if (vtkOITIsSimpleActor(prop))
    {
      continue;
    }
    vtkNew<vtkPropCollection> actors;
    prop->GetActors(actors);
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkProp* part = actors->GetNextProp(it))
    {
      found.push_back(part);
    }
  }
  if (found.empty())
  {
    return found;
  }
  std::set<vtkInformation*> keys;
  std::set<vtkProp*> seen(props.begin(), props.end());
  for (vtkProp* prop : props)
  {
    keys.insert(prop->GetPropertyKeys());
  }
  std::vector<vtkProp*> parts;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    vtkProp* part = found[i];
    if (!seen.insert(part).second)
    {
      continue;
    }
    for (int consumer = 0; consumer < part->GetNumberOfConsumers(); ++consumer)
    {
      if (auto* assembly = vtkProp::SafeDownCast(part->GetConsumer(consumer)))
      {
        found.push_back(assembly);
      }
    }
    if (!part->GetPropertyKeys() || keys.insert(part->GetPropertyKeys()).second)
    {
      parts.push_back(part);
    }
  }
  return parts;
}
