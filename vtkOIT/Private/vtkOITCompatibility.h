// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The one place that knows how VTK's versions differ.
 *
 * VTK 9.1 to 9.3 load OpenGL through GLEW, VTK 9.4 and later through GLAD. Both give the same
 * function and enumerant names.
 */

#ifndef vtkOITCompatibility_h
#define vtkOITCompatibility_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkProp3D.h"
#include "vtkVersionMacros.h"

/// Props in physical or device coordinates came with VTK 9.2.
inline bool vtkOITIsInWorldCoordinates(vtkProp3D* prop)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  return prop->GetCoordinateSystem() == vtkProp3D::WORLD;
#else
  return prop != nullptr;
#endif
}

/// The key was renamed in VTK 9.6.
inline vtkInformationDoubleVectorKey* vtkOITGeneralTextureTransform()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return vtkProp::GENERAL_TEXTURE_TRANSFORM();
#else
  return vtkProp::GeneralTextureTransform();
#endif
}

#endif
