# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Finds the VTK that the classes are built on where there is no plugin.

find_package_folder(vtk_folder VTK vtk-config-version.cmake VTKConfigVersion.cmake)
stop_unless("${vtk_folder}" "VTK 9.1 or later (elsewhere: -DVTK_DIR=FOLDER)" "libvtk9-dev python3-vtk9")
if (vtk_folder MATCHES "^/usr/lib/")
  # Debian's VTK has modules for Debian's Python, whichever python3 comes first in PATH.
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The Python interpreter of VTK")
endif ()
accept_renamed_python_modules("${vtk_folder}")

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
