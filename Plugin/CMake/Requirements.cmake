# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Finds ParaView. Debian's paraview-dev does not depend on everything that ParaView's CMake files go on
# to look for, so each of those is looked for here first.

function (require_qt component package)
  find_package("Qt5${component}" QUIET)
  stop_unless("${Qt5${component}_FOUND}" "Qt5's ${component}" ${package})
endfunction ()

# ParaView runs on Debian's own Python, whichever python3 comes first in PATH.
set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python interpreter of ParaView")

# Debian's ParaView was built with the parallel HDF5, and finds no other.
set(HDF5_PREFER_PARALLEL TRUE)

require_program(pvpython python3-paraview)
require_program(mpicc mpi-default-dev)
require_program(h5pcc libhdf5-openmpi-dev)
require_header(Python.h python3-dev python3.11)
require_header(netcdf.h libnetcdf-dev)
require_header(GL/glew.h libglew-dev)
require_header(double-conversion/double-conversion.h libdouble-conversion-dev)
require_header(ft2build.h libfreetype-dev freetype2)

set(paraview_components RemotingCore RemotingServerManager RemotingViews RemotingApplication
  VTKExtensionsFiltersGeneral)

if (SURFACEGEODESICS_USE_QT)
  require_qt(Widgets qtbase5-dev)
  require_qt(Help qttools5-dev)
  require_qt(Svg libqt5svg5-dev)
  require_qt(OpenGL libqt5opengl5-dev)
  # For the plugin's documentation. The one in /usr/bin is qtchooser's and there with or without the tool.
  require_program(xmlpatterns qtxmlpatterns5-dev-tools /usr/lib/qt5/bin NO_DEFAULT_PATH)
  list(APPEND paraview_components pqCore pqComponents pqApplicationComponents)
endif ()

find_package(ParaView 5.11 QUIET COMPONENTS ${paraview_components})
stop_unless("${ParaView_FOUND}" "ParaView 5.11" paraview-dev)
