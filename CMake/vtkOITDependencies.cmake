# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Finds VTK, GLM and the Python that VTK was built for.

# VTK's own functions call cmake_parse_arguments in a way that CMake 3.31 and later warn about.
set(CMAKE_POLICY_DEFAULT_CMP0174 NEW)

# What the modules, the tests, the benchmarks and the examples use of VTK. Naming the components
# keeps find_package from asking for the development files of everything VTK can do.
set(vtkoit_vtk_components
  CommonCore
  CommonDataModel
  CommonExecutionModel
  RenderingCore
  RenderingOpenGL2
  RenderingUI
  RenderingVolume
  RenderingVolumeOpenGL2)
set(vtkoit_vtk_test_components
  FiltersCore
  FiltersExtraction
  FiltersGeneral
  FiltersGeometry
  FiltersModeling
  FiltersSources
  IOImage
  IOLegacy
  IOXML
  ImagingCore
  ImagingHybrid
  ImagingSources
  InteractionStyle
  RenderingAnnotation
  RenderingFreeType
  TestingCore
  TestingRendering)

# ParaView finds the VTK that it was built with, which is then everybody's.
if(VTKOIT_BUILD_PARAVIEW)
  include(vtkOITParaViewOfDebian)
  # Naming the components keeps it from asking for the development files of Qt.
  find_package(ParaView 5.11 REQUIRED
    COMPONENTS RemotingCore RemotingServerManager RemotingViews)
endif()

find_package(VTK 9.1 REQUIRED
  COMPONENTS ${vtkoit_vtk_components}
  OPTIONAL_COMPONENTS glad glew opengl ${vtkoit_vtk_test_components})

if(BUILD_TESTING AND NOT VTKOIT_BUILD_PARAVIEW) # whose tests need ParaView alone
  foreach(vtkoit_component IN LISTS vtkoit_vtk_test_components)
    if(NOT TARGET VTK::${vtkoit_component})
      message(FATAL_ERROR "vtkOIT: the tests need VTK::${vtkoit_component}, which the VTK in "
        "${VTK_DIR} does not have; configure with -DBUILD_TESTING=OFF to build without tests.")
    endif()
  endforeach()
endif()

find_package(glm QUIET)
if(NOT glm_FOUND)
  message(FATAL_ERROR "vtkOIT: GLM was not found; install it (Debian: libglm-dev) or set glm_DIR.")
endif()

option(VTKOIT_WRAP_PYTHON "Build the Python package" "${VTK_WRAP_PYTHON}")
if(VTKOIT_WRAP_PYTHON)
  if(NOT VTK_WRAP_PYTHON)
    message(FATAL_ERROR "vtkOIT: the VTK in ${VTK_DIR} has no Python wrapping; configure with "
      "-DVTKOIT_WRAP_PYTHON=OFF.")
  endif()
  include(vtkOITFindPython)
  vtkoit_find_python()
  find_package(VTK "${VTK_VERSION}" EXACT REQUIRED
    COMPONENTS ${vtkoit_vtk_components} Python WrappingPythonCore
    OPTIONAL_COMPONENTS glad glew opengl ${vtkoit_vtk_test_components})
endif()
