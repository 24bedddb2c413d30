# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Finds ParaView 5.11 or later: Debian's, or another one by -DParaView_DIR=FOLDER or -DCMAKE_PREFIX_PATH=PREFIX.

function (require_qt qt component package)
  find_package("${qt}${component}" QUIET)
  stop_unless("${${qt}${component}_FOUND}" "${qt}'s ${component}" ${package})
endfunction ()

# Debian's paraview-dev does not depend on everything that ParaView's CMake files go on to look for, so each of those is
# looked for here first.
macro (require_what_debian_leaves_out)
  # ParaView runs on Debian's own Python, whichever python3 comes first in PATH.
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python interpreter of ParaView")
  # Debian's ParaView was built with the parallel HDF5, and finds no other.
  set(HDF5_PREFER_PARALLEL TRUE)
  find_package(Python3 QUIET COMPONENTS Interpreter)
  require_program(pvpython python3-paraview)
  require_program(mpicc mpi-default-dev)
  require_program(h5pcc libhdf5-openmpi-dev)
  require_header(Python.h python3-dev "python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
  require_header(netcdf.h libnetcdf-dev)
  require_header(GL/glew.h libglew-dev)
  require_header(double-conversion/double-conversion.h libdouble-conversion-dev)
  require_header(ft2build.h libfreetype-dev freetype2)
endmacro ()

function (require_qt_of_debian qt)
  if (qt STREQUAL "Qt5")
    require_qt(Qt5 Widgets qtbase5-dev)
    require_qt(Qt5 Help qttools5-dev)
    require_qt(Qt5 Svg libqt5svg5-dev)
    require_qt(Qt5 OpenGL libqt5opengl5-dev)
  else ()
    require_qt(Qt6 Widgets qt6-base-dev)
    require_qt(Qt6 Help qt6-tools-dev)
    require_qt(Qt6 Svg qt6-svg-dev)
    require_qt(Qt6 Core5Compat qt6-5compat-dev)
  endif ()
endfunction ()

function (require_help_program program)
  if (program STREQUAL "xmlpatterns")
    # The one in /usr/bin is qtchooser's and there with or without the tool.
    require_program(xmlpatterns qtxmlpatterns5-dev-tools /usr/lib/qt5/bin NO_DEFAULT_PATH)
  elseif (program)
    require_program("${program}" "${program}")
  endif ()
endfunction ()

find_package_folder(paraview_folder ParaView paraview-config-version.cmake ParaViewConfigVersion.cmake)
stop_unless("${paraview_folder}" "ParaView 5.11 or later (elsewhere: -DParaView_DIR=FOLDER)" paraview-dev)
if (paraview_folder MATCHES "^/usr/lib/")
  set(paraview_is_debians TRUE)
  require_what_debian_leaves_out()
endif ()
accept_renamed_python_modules("${paraview_folder}")
accept_renamed_python_modules("${paraview_folder}/vtk")

set(paraview_components RemotingCore RemotingServerManager RemotingViews RemotingApplication
  VTKExtensionsFiltersGeneral)
find_package(ParaView 5.11 QUIET COMPONENTS ${paraview_components})
stop_unless("${ParaView_FOUND}"
  "ParaView 5.11 or later (of ${paraview_folder}: ${ParaView_NOT_FOUND_MESSAGE})" paraview-dev)

if (SURFACEGEODESICS_USE_QT)
  get_qt_of_paraview(qt)
  get_help_program_of_paraview(help_program "${qt}")
  if (paraview_is_debians)
    require_qt_of_debian("${qt}")
    require_help_program("${help_program}")
  endif ()
  find_package(ParaView 5.11 QUIET REQUIRED
    COMPONENTS ${paraview_components} pqCore pqComponents pqApplicationComponents)
endif ()
