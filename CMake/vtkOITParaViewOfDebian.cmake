# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# paraview-dev of Debian 13 (5.13) and later lists Python modules in its CMake files by names that its
# packages do not have: vtkPVVersioning.so, installed as vtkPVVersioning.cpython-313-x86_64-linux-gnu.so.
# CMake checks that they exist, so that nothing configures with it. Included before find_package(ParaView),
# this makes their imported targets with the names that are there; ParaView's own files then find all of
# them made, and pass over their lists. Does nothing where the names are right, or with another ParaView.

file(GLOB vtkoit_debian_paraview "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/paraview-config.cmake")
get_filename_component(vtkoit_debian_paraview "${vtkoit_debian_paraview}" DIRECTORY)
set(vtkoit_debian_modules "/usr/lib/python3/dist-packages/paraview/modules")
file(GLOB vtkoit_debian_module "${vtkoit_debian_modules}/vtkPVVersioning.*.so")
if(NOT vtkoit_debian_paraview
    OR (ParaView_DIR AND NOT ParaView_DIR STREQUAL vtkoit_debian_paraview)
    OR NOT vtkoit_debian_module
    OR EXISTS "${vtkoit_debian_modules}/vtkPVVersioning.so")
  return()
endif()

string(REGEX MATCH "vtkPVVersioning(\\..*)$" vtkoit_debian_module "${vtkoit_debian_module}")
set(vtkoit_debian_suffix "${CMAKE_MATCH_1}")
message(STATUS "vtkOIT: Python modules of ${vtkoit_debian_paraview} end in ${vtkoit_debian_suffix}")
set(vtkoit_debian_lists ParaViewPython ParaViewPythonIncubator)
if(EXISTS "${vtkoit_debian_paraview}/vtk/VTKPython-targets.cmake") # a VTK of its own
  list(INSERT vtkoit_debian_lists 0 vtk/VTKPython)
else()
  find_package(VTK REQUIRED COMPONENTS CommonCore) # the lists need its targets
endif()
set(vtkoit_debian_copies "${CMAKE_BINARY_DIR}/CMakeFiles/paraview-of-debian")
foreach(vtkoit_debian_list IN LISTS vtkoit_debian_lists)
  set(vtkoit_debian_original "${vtkoit_debian_paraview}/${vtkoit_debian_list}-targets.cmake")
  file(GLOB vtkoit_debian_parts "${vtkoit_debian_paraview}/${vtkoit_debian_list}-targets*.cmake")
  foreach(vtkoit_debian_part IN LISTS vtkoit_debian_parts)
    file(READ "${vtkoit_debian_part}" vtkoit_debian_text)
    # The prefix follows from where the list lies.
    string(REPLACE "\${CMAKE_CURRENT_LIST_FILE}" "${vtkoit_debian_original}"
      vtkoit_debian_text "${vtkoit_debian_text}")
    string(REPLACE ".so\"" "${vtkoit_debian_suffix}\"" vtkoit_debian_text "${vtkoit_debian_text}")
    file(RELATIVE_PATH vtkoit_debian_part "${vtkoit_debian_paraview}" "${vtkoit_debian_part}")
    file(WRITE "${vtkoit_debian_copies}/${vtkoit_debian_part}" "${vtkoit_debian_text}")
  endforeach()
  include("${vtkoit_debian_copies}/${vtkoit_debian_list}-targets.cmake")
endforeach()
