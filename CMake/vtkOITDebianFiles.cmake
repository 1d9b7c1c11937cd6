# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Run by cpack between the installation and the packing: what Debian's policy asks of each package
# beyond the files that are installed anywhere: copyright, changelogs, compressed manual pages, and
# no search paths in libraries, which the system's linker finds (but for those in a folder of their own).

# Compresses a file in its place, with neither name nor time in it.
function(vtkoit_compress file)
  execute_process(COMMAND gzip --no-name --best --force "${file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(components RUNTIME DEVELOPMENT PYTHON PARAVIEW)
foreach(component IN LISTS components)
  string(TOLOWER "${component}" folder)
  set(tree "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${folder}${CPACK_PACKAGING_INSTALL_PREFIX}")
  if(NOT IS_DIRECTORY "${tree}")
    continue()
  endif()
  set(name "${CPACK_DEBIAN_${component}_PACKAGE_NAME}")
  set(documentation "${tree}/share/doc/${name}")

  # The licence is in the file copyright.
  file(REMOVE_RECURSE "${tree}/share/licenses")
  file(READ "${CPACK_VTKOIT_SOURCE_DIR}/LICENSE" licence)
  file(WRITE "${documentation}/copyright" "vtkOIT: order-independent transparency for VTK\n\n${licence}")
  file(COPY_FILE "${CPACK_VTKOIT_SOURCE_DIR}/CHANGELOG.md" "${documentation}/changelog")
  file(WRITE "${documentation}/changelog.Debian"
    "vtkoit (${CPACK_VTKOIT_DEBIAN_VERSION}) unstable; urgency=medium\n\n"
    "  * Package made by CPack from the sources; changelog.gz tells what is new.\n\n"
    " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${CPACK_VTKOIT_DATE}\n")
  vtkoit_compress("${documentation}/changelog")
  vtkoit_compress("${documentation}/changelog.Debian")
  file(GLOB_RECURSE pages "${tree}/share/man/*.[1-8]")
  foreach(page IN LISTS pages)
    vtkoit_compress("${page}")
  endforeach()
  file(GLOB_RECURSE libraries "${tree}/lib/*.so" "${tree}/lib/*.so.*")
  foreach(library IN LISTS libraries)
    if(NOT IS_SYMLINK "${library}" AND NOT component STREQUAL "PARAVIEW")
      file(RPATH_REMOVE FILE "${library}")
    endif()
  endforeach()
  # Whatever the umask of whoever builds.
  execute_process(COMMAND chmod -R u=rwX,go=rX "${tree}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
