# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# cmake "-DCOMMAND=program;arguments" -DPICTURE= [-DSAME_AS=] -P RunAndCheck.cmake
# Runs `program arguments PICTURE` with no help from the environment, then checks that the file is a
# PNG with a picture in it, and equal to the file SAME_AS when that is given.
file(REMOVE "${PICTURE}")
foreach(variable IN ITEMS DISPLAY LD_LIBRARY_PATH LD_PRELOAD PYTHONPATH VTK_DEFAULT_OPENGL_WINDOW)
  unset(ENV{${variable}})
endforeach()
execute_process(
  COMMAND ${COMMAND} "${PICTURE}"
  COMMAND_ECHO STDOUT
  ERROR_VARIABLE errors
  RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR errors)
  message(FATAL_ERROR "${COMMAND} ended with ${result} and wrote:\n${errors}")
endif()

if(NOT EXISTS "${PICTURE}")
  message(FATAL_ERROR "${COMMAND} wrote no ${PICTURE}")
endif()
file(READ "${PICTURE}" head LIMIT 8 HEX)
if(NOT head STREQUAL "89504e470d0a1a0a")
  message(FATAL_ERROR "${PICTURE} is not a PNG file")
endif()
# An empty picture of these sizes compresses to less than 2000 bytes, the examples to over 10000.
file(SIZE "${PICTURE}" size)
if(size LESS 4000)
  message(FATAL_ERROR "${PICTURE} has only ${size} bytes: it shows nothing")
endif()
if(SAME_AS)
  file(SHA256 "${PICTURE}" picture_hash)
  file(SHA256 "${SAME_AS}" same_hash)
  if(NOT picture_hash STREQUAL same_hash)
    message(FATAL_ERROR "${PICTURE} differs from ${SAME_AS}")
  endif()
endif()
message(STATUS "${PICTURE}: ${size} bytes")
