# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Run by cpack before it makes a package, once for each generator.

if(CPACK_GENERATOR STREQUAL "DEB")
  # The folders of libraries and of Python follow the prefix.
  if(NOT CPACK_VTKOIT_PREFIX STREQUAL "/usr")
    message(FATAL_ERROR "vtkOIT: this build folder is for ${CPACK_VTKOIT_PREFIX}, packages of Debian are for /usr; "
      "make them by: cmake --preset packages && cmake --build --preset packages && cpack --preset packages")
  endif()
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
else()
  set(CPACK_PRE_BUILD_SCRIPTS)
endif()
