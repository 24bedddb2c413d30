# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Stops the configure where something is missing, with the name of the package to install.

function (stop_unless found what package)
  if (NOT found)
    message(FATAL_ERROR "${what} is missing. On Debian: apt-get install ${package}")
  endif ()
endfunction ()

function (require_header header package)
  find_path(directory "${header}" PATH_SUFFIXES ${ARGN} NO_CACHE)
  stop_unless("${directory}" "The header ${header}" ${package})
endfunction ()

function (require_program program package)
  find_program(path "${program}" PATHS ${ARGN} NO_CACHE)
  stop_unless("${path}" "The program ${program}" ${package})
endfunction ()

# The folder of a package's CMake files, found as find_package finds it, but not yet read. ARGN: the names that the file
# with its version can have.
function (find_package_folder variable package)
  find_package(FolderOfPackage QUIET
    NAMES "${package}"
    CONFIGS ${ARGN}
    HINTS ${${package}_DIR} ${${package}_ROOT} "$ENV{${package}_ROOT}")
  set("${variable}" "${FolderOfPackage_DIR}" PARENT_SCOPE)
  unset(FolderOfPackage_DIR CACHE)
endfunction ()
