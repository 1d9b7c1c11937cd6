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

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkProp3D.h"
#include "vtkVersionMacros.h"

#include <vector>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#else
#include "vtkCompositePolyDataMapper2.h"
#endif

/// What an object factory says of itself becomes const in some VTK after 9.3, which announces it so.
#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST
#endif

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

/// Physically based rendering: beside positional lights VTK has directional ones come from their position;
/// mended between VTK 9.3 and 9.6.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
constexpr bool vtkOITDirectionalFromPosition = false;
#else
constexpr bool vtkOITDirectionalFromPosition = true;
#endif

/// The mapper of composite data whose blocks have attributes of their own: it took the name of an
/// older one in VTK 9.3.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using vtkOITCompositeMapper = vtkCompositePolyDataMapper;
#else
using vtkOITCompositeMapper = vtkCompositePolyDataMapper2;
#endif

/// Whether a mapper draws selected cells besides its mesh: they came with vtkMapper::SetSelection().
///@{
template <typename Mapper>
auto vtkOITDrawsSelection(Mapper* mapper, int) -> decltype(mapper->GetSelection() != nullptr)
{
  return mapper->GetSelection() != nullptr;
}
template <typename Mapper>
bool vtkOITDrawsSelection(Mapper*, long)
{
  return false;
}
///@}

/// The shaders of a program: those for tessellation came after VTK 9.1.
///@{
template <typename Shader>
auto vtkOITGetShaderTypes(int)
  -> std::vector<decltype(Shader::TessControl, typename Shader::Type())>
{
  return { Shader::Vertex, Shader::Geometry, Shader::Fragment, Shader::TessControl,
    Shader::TessEvaluation };
}
template <typename Shader>
std::vector<typename Shader::Type> vtkOITGetShaderTypes(long)
{
  return { Shader::Vertex, Shader::Geometry, Shader::Fragment };
}
///@}

/// Whether blocks have lookup tables (VTK 9.3) or textures (VTK 9.6) of their own.
///@{
template <typename Attributes>
auto vtkOITHasBlockTables(Attributes* attributes, int)
  -> decltype(attributes->HasBlockLookupTables())
{
  return attributes->HasBlockLookupTables();
}
template <typename Attributes>
bool vtkOITHasBlockTables(Attributes*, long)
{
  return false;
}
template <typename Attributes>
auto vtkOITHasBlockTextures(Attributes* attributes, int) -> decltype(attributes->HasBlockTextures())
{
  return attributes->HasBlockTextures();
}
template <typename Attributes>
bool vtkOITHasBlockTextures(Attributes*, long)
{
  return false;
}
///@}

#endif
