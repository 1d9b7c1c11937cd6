# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Prints every option, once, at the end of the configuration.

if(NOT vtkoit_is_multi_config)
  set(vtkoit_summary_build_type "${CMAKE_BUILD_TYPE}")
endif()
list(JOIN vtkoit_modules ", " vtkoit_summary_modules)
message(STATUS "vtkOIT ${PROJECT_VERSION}")
message(STATUS "  VTK                      ${VTK_VERSION} (${VTK_DIR})")
message(STATUS "  modules                  ${vtkoit_summary_modules}")
message(STATUS "  compiler                 ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
message(STATUS "  build type               ${vtkoit_summary_build_type}")
message(STATUS "  BUILD_SHARED_LIBS        ${BUILD_SHARED_LIBS}")
message(STATUS "  BUILD_TESTING            ${BUILD_TESTING}")
message(STATUS "  VTKOIT_WRAP_PYTHON       ${VTKOIT_WRAP_PYTHON} ${Python3_EXECUTABLE}")
message(STATUS "  VTKOIT_BUILD_PARAVIEW    ${VTKOIT_BUILD_PARAVIEW} ${ParaView_VERSION}")
message(STATUS "  VTKOIT_WERROR            ${VTKOIT_WERROR}")
message(STATUS "  VTKOIT_SANITIZE_ADDRESS  ${VTKOIT_SANITIZE_ADDRESS}")
message(STATUS "  install prefix           ${CMAKE_INSTALL_PREFIX}")
