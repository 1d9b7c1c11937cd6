// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPropParts_h
#define vtkOITPropParts_h

#include <vector>

class vtkProp;

/// Whether a prop is an actor that one of VTK's own mappers draws, or one derived of
/// those, all of which ask our hooks.
bool vtkOITIsSimpleActor(vtkProp* prop);

/// Whether a prop adds its colours to what is behind it instead of covering that: emissive Gaussians.
bool vtkOITAddsLight(vtkProp* prop);

/// Whether each draw of these props asks our hooks, so that the hooks know the order of draws. It does
/// not where a mapper draws blocks of composite data, or instances of a glyph, one by one.
bool vtkOITDrawsInOrder(const std::vector<vtkProp*>& props);

/// The actors and assemblies that props say they are made of (vtkProp::GetActors()), such as the faces of a
/// vtkAnnotatedCubeActor, and that they do not hand on their property keys to, as assemblies do.
std::vector<vtkProp*> vtkOITFindParts(const std::vector<vtkProp*>& props);

#endif
