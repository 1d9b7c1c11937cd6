# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DSOURCE= -DBINARY= -DPREFIX= -DGENERATOR= -DC_COMPILER= -DCXX_COMPILER= -DFLAGS= -DVTK_DIR=
#       -DPROGRAM= -DPICTURE= -P BuildAndRun.cmake
# Configures an outside project in SOURCE against the vtkOIT in PREFIX, builds it, and runs PROGRAM.
file(REMOVE_RECURSE "${BINARY}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BINARY}" -G "${GENERATOR}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${FLAGS}"
    -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_PREFIX_PATH=${PREFIX}"
    "-DVTK_DIR=${VTK_DIR}"
  ERROR_VARIABLE errors
  COMMAND_ECHO STDOUT
  RESULT_VARIABLE result)
# A consumer must see no CMake warning from our package files; those of VTK's own are not ours.
if(NOT result EQUAL 0 OR errors MATCHES "vtkOIT")
  message(FATAL_ERROR "configuring ${SOURCE} failed or warned:\n${errors}")
endif()
execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${BINARY}"
  COMMAND_ECHO STDOUT
  COMMAND_ERROR_IS_FATAL ANY)

set(COMMAND "${BINARY}/${PROGRAM}")
include("${CMAKE_CURRENT_LIST_DIR}/RunAndCheck.cmake")
