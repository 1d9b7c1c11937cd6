# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Wraps the modules into the Python package vtkoit: vtkoit.vtkOIT and vtkoit.vtkOITOSMesa. The
# pure Python part of the package comes from Wrapping/Python/.

vtk_module_python_default_destination(vtkoit_python_destination)
set(VTKOIT_PYTHON_DESTINATION "${vtkoit_python_destination}" CACHE STRING
  "Folder of the Python package vtkoit, relative to the prefix")
set(vtkoit_python_destination "${VTKOIT_PYTHON_DESTINATION}")

vtk_module_wrap_python(
  MODULES ${vtkoit_modules}
  TARGET vtkOIT::Python
  WRAPPED_MODULES vtkoit_wrapped_modules
  INSTALL_EXPORT vtkOITPython
  PYTHON_PACKAGE vtkoit
  MODULE_DESTINATION "${vtkoit_python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${vtkoit_cmake_destination}"
  SOABI "${Python3_SOABI}"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)

# The generated sources are VTK's: its 9.3 does not know a field that Python 3.13 added.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  foreach(vtkoit_module IN LISTS vtkoit_wrapped_modules)
    string(REPLACE "vtkOIT::" "" vtkoit_library "${vtkoit_module}")
    target_compile_options("${vtkoit_library}Python" PRIVATE -Wno-missing-field-initializers)
  endforeach()
endif()
