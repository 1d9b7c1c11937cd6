# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Packages by CPack, in the build folder of the preset packages:
#
#   cpack -G DEB  libvtkoit<version>, libvtkoit-dev and python3-vtkoit for the release of Debian that
#                 they are made on: each component of the installation is a package
#   cpack -G TXZ  all of it in one archive, for a folder of the user's choice
#
# in that of the preset paraview:
#
#   cpack -G DEB  paraview-vtkoit, the plugin for the ParaView of that release, which needs no other

set(CPACK_PACKAGE_NAME "vtkoit")
set(CPACK_PACKAGE_VENDOR "the vtkOIT developers")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGE_FILE_NAME
  "vtkoit-${PROJECT_VERSION}-vtk${VTK_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE")
set(CPACK_GENERATOR TXZ)
set(CPACK_SOURCE_GENERATOR TXZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_COMPONENTS_ALL runtime development)
if(VTKOIT_WRAP_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
if(VTKOIT_BUILD_PARAVIEW) # all else would be for ParaView's VTK
  set(CPACK_COMPONENTS_ALL paraview)
endif()
# What differs between the two.
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtkOITPackagesOf.cmake")

# ---------------------------------------------------------------------------------------------
# Debian
set(VTKOIT_PACKAGE_MAINTAINER "the vtkOIT developers <vtkoit@users.noreply.github.com>" CACHE STRING
  "Maintainer of the packages: NAME <ADDRESS>")
mark_as_advanced(VTKOIT_PACKAGE_MAINTAINER)
set(vtkoit_debian_release 1)
if(EXISTS /etc/os-release)
  file(STRINGS /etc/os-release vtkoit_os_version REGEX "^VERSION_ID=")
  # Testing has none, and is later than any release.
  if(vtkoit_os_version MATCHES "([0-9.]+)")
    set(vtkoit_debian_release "1~deb${CMAKE_MATCH_1}")
  endif()
endif()
set(vtkoit_debian_version "${PROJECT_VERSION}-${vtkoit_debian_release}")
set(vtkoit_debian_library "libvtkoit${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
math(EXPR vtkoit_next_vtk "${VTK_MINOR_VERSION} + 1")
set(vtkoit_debian_vtk "(>= ${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION})")
set(vtkoit_debian_before_vtk "(<< ${VTK_MAJOR_VERSION}.${vtkoit_next_vtk})")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${vtkoit_debian_release}")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${VTKOIT_PACKAGE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Beside each other in the build folder, and in the package that the others depend on.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtkOITDebianFiles.cmake")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "${vtkoit_debian_library}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "Render passes of VTK that draw translucent geometry in the right order at
every pixel, whatever the order of triangles and props.
.
This package has the libraries.")
if(VTK_VERSION VERSION_LESS 9.4)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libosmesa6")
else()
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "libegl1, libgl1-mesa-dri")
endif()
# What packages that link the libraries will depend on, and the cache of the loader.
set(vtkoit_control "${CMAKE_CURRENT_BINARY_DIR}/debian")
file(CONFIGURE OUTPUT "${vtkoit_control}/shlibs" @ONLY CONTENT
"libvtkOIT @PROJECT_VERSION_MAJOR@.@PROJECT_VERSION_MINOR@ @vtkoit_debian_library@ (= @vtkoit_debian_version@)
libvtkOITOSMesa @PROJECT_VERSION_MAJOR@.@PROJECT_VERSION_MINOR@ @vtkoit_debian_library@ (= @vtkoit_debian_version@)
")
file(WRITE "${vtkoit_control}/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${vtkoit_control}/shlibs" "${vtkoit_control}/triggers")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME "libvtkoit-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Render passes of VTK that draw translucent geometry in the right order at
every pixel, whatever the order of triangles and props.
.
This package has the headers and the files of find_package(vtkOIT) for CMake.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${vtkoit_debian_library} (= ${vtkoit_debian_version}), libvtk9-dev ${vtkoit_debian_vtk}, libvtk9-dev ${vtkoit_debian_before_vtk}")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME "python3-vtkoit")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Render passes of VTK that draw translucent geometry in the right order at
every pixel, whatever the order of triangles and props.
.
This package has the Python package vtkoit, and the command line vtkoit, which
draws data files to pictures and compares the methods with VTK's own.")
if(VTKOIT_WRAP_PYTHON)
  get_directory_property(vtkoit_python_version DIRECTORY Wrapping/Python DEFINITION vtkoit_python_version)
  string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" vtkoit_python3 "${vtkoit_python_version}")
  math(EXPR vtkoit_next_python "${CMAKE_MATCH_2} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "${vtkoit_debian_library} (= ${vtkoit_debian_version}), python3 (>= ${vtkoit_python3}~), python3 (<< 3.${vtkoit_next_python}~), python3:any, python3-numpy, python3-vtk9 ${vtkoit_debian_vtk}, python3-vtk9 ${vtkoit_debian_before_vtk}")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/debian/postinst"
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/debian/prerm")

set(CPACK_DEBIAN_PARAVIEW_PACKAGE_NAME "paraview-vtkoit")
set(CPACK_DEBIAN_PARAVIEW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PARAVIEW_DESCRIPTION "Plugin for ParaView that draws translucent geometry in the right order at
every pixel, whatever the order of triangles and sources.
.
The command paraview-vtkoit starts ParaView's programs with it.")
if(VTKOIT_BUILD_PARAVIEW)
  # The plugin's folder has the versions in its name.
  math(EXPR vtkoit_next_paraview "${ParaView_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PARAVIEW_PACKAGE_DEPENDS
    "paraview (>= ${ParaView_VERSION_SIMPLE}), paraview (<< ${ParaView_VERSION_MAJOR}.${vtkoit_next_paraview}~)")
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
    "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${PARAVIEW_PLUGIN_SUBDIR}/vtkOITParaView")
endif()

# For vtkOITDebianFiles.cmake.
set(CPACK_VTKOIT_DEBIAN_VERSION "${vtkoit_debian_version}")
set(CPACK_VTKOIT_SOURCE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
set(CPACK_VTKOIT_PREFIX "${CMAKE_INSTALL_PREFIX}")
string(TIMESTAMP CPACK_VTKOIT_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)

include(CPack)
