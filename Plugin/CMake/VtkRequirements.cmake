# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Finds the VTK that the classes are built on where there is no plugin.

# VTK's Python modules are Debian's, whichever python3 comes first in PATH.
set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python interpreter of VTK")

find_package(VTK 9.1 QUIET COMPONENTS
  CommonCore
  CommonDataModel
  CommonExecutionModel
  CommonSystem
  FiltersCore
  FiltersExtraction
  FiltersGeneral
  FiltersGeometry
  FiltersModeling
  FiltersSources
  IOImage
  IOXML
  InteractionStyle
  InteractionWidgets
  ParallelCore
  RenderingAnnotation
  RenderingCore
  RenderingFreeType
  RenderingOpenGL2
  RenderingUI
  WrappingPythonCore
  vtksys)
stop_unless("${VTK_FOUND}" "VTK 9.1 or later, with Python, (${VTK_NOT_FOUND_MESSAGE})" "libvtk9-dev python3-vtk9")
