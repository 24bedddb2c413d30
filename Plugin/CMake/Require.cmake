# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Stops the configure where something is missing, with the name of the package to install.

function (stop_unless found what package)
  if (NOT found)
    message(FATAL_ERROR "${what} is missing. Debian 12: apt-get install ${package}")
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
