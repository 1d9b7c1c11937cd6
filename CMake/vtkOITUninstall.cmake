# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# The target uninstall: removes what was last installed from this build folder. As a script
# (cmake -DBUILD=<build folder> -P) it is what the target runs.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  if(NOT TARGET uninstall)
    add_custom_target(uninstall
      COMMAND "${CMAKE_COMMAND}" "-DBUILD=${CMAKE_BINARY_DIR}" -P "${CMAKE_CURRENT_LIST_FILE}"
      COMMENT "Removing what was installed"
      VERBATIM)
  endif()
  return()
endif()

# One of all, or one of each component that was installed alone; paths without DESTDIR.
file(GLOB manifests "${BUILD}/install_manifest*.txt")
if(NOT manifests)
  message(FATAL_ERROR "vtkOIT: nothing was installed from ${BUILD}: it has no install_manifest.txt.")
endif()

set(folders)
set(common) # the folder of all files
set(count 0)
foreach(manifest IN LISTS manifests)
  file(STRINGS "${manifest}" files ENCODING UTF-8)
  foreach(file IN LISTS files)
    set(path "$ENV{DESTDIR}${file}")
    get_filename_component(folder "${path}" DIRECTORY)
    list(APPEND folders "${folder}")
    if(NOT common)
      set(common "${folder}")
    endif()
    string(FIND "${folder}/" "${common}/" common_at)
    while(NOT common_at EQUAL 0)
      get_filename_component(common "${common}" DIRECTORY)
      string(FIND "${folder}/" "${common}/" common_at)
    endwhile()
    if(EXISTS "${path}" OR IS_SYMLINK "${path}")
      file(REMOVE "${path}")
      math(EXPR count "${count} + 1")
    endif()
    # What Python has compiled of it, without which `import vtkoit` finds nothing.
    if(file MATCHES "/([^/]+)\\.py$")
      file(GLOB compiled "${folder}/__pycache__/${CMAKE_MATCH_1}.*.pyc")
      if(compiled)
        file(REMOVE ${compiled})
      endif()
      list(APPEND folders "${folder}/__pycache__")
    endif()
  endforeach()
endforeach()

# Folders that are empty now, the deepest first; they may have been there before, and are ours only
# where our name is in the path, behind what all files have in common: that may have it by chance.
if(common MATCHES "/[^/]*vtk[oO][iI][tT][^/]*$")
  get_filename_component(common "${common}" DIRECTORY)
endif()
string(LENGTH "${common}" common_length)
list(REMOVE_DUPLICATES folders)
set(wanted)
foreach(folder IN LISTS folders)
  string(LENGTH "${folder}" length)
  while(length GREATER common_length)
    string(SUBSTRING "${folder}" ${common_length} -1 behind)
    if(NOT behind MATCHES "/[^/]*vtk[oO][iI][tT]" OR NOT IS_DIRECTORY "${folder}")
      break()
    endif()
    list(APPEND wanted "${folder}")
    get_filename_component(folder "${folder}" DIRECTORY)
    string(LENGTH "${folder}" length)
  endwhile()
endforeach()
list(REMOVE_DUPLICATES wanted)
list(SORT wanted ORDER DESCENDING)
foreach(folder IN LISTS wanted)
  file(GLOB rest "${folder}/*")
  if(NOT rest)
    file(REMOVE_RECURSE "${folder}")
  endif()
endforeach()

file(REMOVE ${manifests})
message(STATUS "vtkOIT: ${count} files removed")
