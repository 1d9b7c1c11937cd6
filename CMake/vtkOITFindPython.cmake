# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# vtkoit_find_python()
#
# Sets the cache variable Python3_EXECUTABLE to the interpreter that the found VTK was built for,
# whichever python3 comes first in PATH: one of the version that VTK's wrapping library carries
# in its name and that can import vtkmodules. A Python3_EXECUTABLE given by the user is kept, and
# refused with a reason when it cannot work.
function(vtkoit_find_python)
  get_target_property(configurations VTK::WrappingPythonCore IMPORTED_CONFIGURATIONS)
  list(GET configurations 0 configuration)
  get_target_property(library VTK::WrappingPythonCore "IMPORTED_LOCATION_${configuration}")
  get_filename_component(library "${library}" NAME)
  if(NOT library MATCHES "vtkWrappingPythonCore(3\\.[0-9]+)")
    message(FATAL_ERROR "vtkOIT: cannot tell from ${library} which Python VTK was built for; "
      "configure with -DVTKOIT_WRAP_PYTHON=OFF.")
  endif()
  set(version "${CMAKE_MATCH_1}")

  if(Python3_EXECUTABLE)
    set(candidates "${Python3_EXECUTABLE}")
  else()
    # The interpreter of VTK's own prefix first (/usr for a distribution package), then PATH,
    # then the system's folders, in case PATH is led by an environment manager.
    set(candidates)
    foreach(name IN ITEMS "python${version}" python3)
      foreach(folder IN ITEMS "${VTK_PREFIX_PATH}/bin" "/usr/bin" "/usr/local/bin")
        if(EXISTS "${folder}/${name}")
          list(APPEND candidates "${folder}/${name}")
        endif()
      endforeach()
      find_program(vtkoit_python_in_path NAMES "${name}" NO_CACHE)
      if(vtkoit_python_in_path)
        list(APPEND candidates "${vtkoit_python_in_path}")
      endif()
      unset(vtkoit_python_in_path)
    endforeach()
  endif()

  set(reasons)
  foreach(candidate IN LISTS candidates)
    execute_process(
      COMMAND "${candidate}" -c
        "import sys, vtkmodules; print('%d.%d' % sys.version_info[:2])"
      RESULT_VARIABLE result
      OUTPUT_VARIABLE output
      ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT result EQUAL 0)
      list(APPEND reasons "${candidate} cannot import vtkmodules")
    elseif(NOT output STREQUAL version)
      list(APPEND reasons "${candidate} is Python ${output}")
    else()
      set(Python3_EXECUTABLE "${candidate}" CACHE FILEPATH
        "The Python that VTK was built for" FORCE)
      return()
    endif()
  endforeach()

  list(JOIN reasons "; " reasons)
  message(FATAL_ERROR "vtkOIT: no Python ${version} with VTK's Python package was found "
    "(${reasons}); install it (Debian: python3-vtk9) or configure with -DVTKOIT_WRAP_PYTHON=OFF.")
endfunction()
