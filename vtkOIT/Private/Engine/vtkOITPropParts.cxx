// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Engine/vtkOITPropParts.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <array>
#include <cstring>
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
  return mapper && std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0 &&
    std::any_of(names.begin(), names.end(),
      [mapper](const char* name) { return std::strcmp(mapper->GetClassName(), name) == 0; });
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITFindParts(const std::vector<vtkProp*>& props)
{
  // Parts share the keys of their prop where it hands them on.
  std::set<vtkInformation*> keys;
  for (vtkProp* prop : props)
  {
    keys.insert(prop->GetPropertyKeys());
  }
  std::vector<vtkProp*> parts;
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
      if (part != prop && (!part->GetPropertyKeys() || keys.insert(part->GetPropertyKeys()).second))
      {
        parts.push_back(part);
      }
    }
  }
  return parts;
}
