# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# The package configuration, for the build tree and for the install tree alike: the same files in
# the same place relative to the tree, so CMAKE_PREFIX_PATH may name either one.

include(CMakePackageConfigHelpers)

# The VTK components that a consumer needs: what the modules depend on, tests left out.
set(vtkoit_package_vtk_components)
foreach(vtkoit_module IN LISTS vtkoit_modules)
  foreach(vtkoit_kind IN ITEMS depends private_depends optional_depends)
    get_property(vtkoit_depends
      TARGET "${vtkoit_module}"
      PROPERTY "INTERFACE_vtk_module_${vtkoit_kind}")
    foreach(vtkoit_depend IN LISTS vtkoit_depends)
      if(vtkoit_depend MATCHES "^VTK::(.*)$" AND TARGET "${vtkoit_depend}")
        list(APPEND vtkoit_package_vtk_components "${CMAKE_MATCH_1}")
      endif()
    endforeach()
  endforeach()
endforeach()
list(REMOVE_DUPLICATES vtkoit_package_vtk_components)

set(vtkoit_package_directory "${CMAKE_BINARY_DIR}/${vtkoit_cmake_destination}")
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtkOITConfig.cmake.in"
  "${vtkoit_package_directory}/vtkOITConfig.cmake"
  INSTALL_DESTINATION "${vtkoit_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${vtkoit_package_directory}/vtkOITConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)

install(
  FILES
    "${vtkoit_package_directory}/vtkOITConfig.cmake"
    "${vtkoit_package_directory}/vtkOITConfigVersion.cmake"
  DESTINATION "${vtkoit_cmake_destination}"
  COMPONENT development)
if(NOT SKBUILD) # a wheel has it among its metadata
  install(
    FILES LICENSE
    DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/vtkOIT"
    COMPONENT runtime)
endif()
