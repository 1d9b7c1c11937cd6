# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Where things are built, and how they find each other: no program, library or Python module of
# ours needs LD_LIBRARY_PATH, neither in the build tree nor installed. The Python modules get
# their own entry from vtk_module_wrap_python().

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

if(UNIX AND NOT APPLE)
  file(RELATIVE_PATH vtkoit_bin_to_lib
    "/prefix/${CMAKE_INSTALL_BINDIR}" "/prefix/${CMAKE_INSTALL_LIBDIR}")
  list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/${vtkoit_bin_to_lib}")
endif()

# For a VTK outside the system's folders. One in them finds all that it needs, and packages must not name
# folders of other packages, such as that of HDF5, to which ParaView links.
if(NOT VTK_DIR MATCHES "^/usr/lib/")
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
endif()
