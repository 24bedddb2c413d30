# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# The VTK modules and the Python package of their classes. They are built outside the plugin, so that
# only the classes that its XML names are wrapped for the client-server interpreter.

if (SURFACEGEODESICS_PYTHON_DESTINATION)
  set(python_destination "${SURFACEGEODESICS_PYTHON_DESTINATION}")
elseif (NOT SURFACEGEODESICS_BUILD_PLUGIN)
  vtk_module_python_default_destination(python_destination)
else ()
  set(python_destination "${PARAVIEW_PYTHONPATH}")
endif ()

set(BUILD_SHARED_LIBS ON)

set(module_cmake_directory "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceGeodesics")
set(python_package_directory "${python_destination}/surfacegeodesics")

set(module_folders Filters/Geodesics Filters/Surface Widgets/Tracing)
set(python_modules
  SurfaceGeodesics::FiltersGeodesics
  SurfaceGeodesics::FiltersSurface
  SurfaceGeodesics::WidgetsTracing)
set(paraview_modules)
if (SURFACEGEODESICS_BUILD_PLUGIN)
  list(APPEND module_folders Widgets/Fields Widgets/Lines)
  set(paraview_modules SurfaceGeodesics::WidgetsFields SurfaceGeodesics::WidgetsLines)
endif ()
list(TRANSFORM module_folders REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1/vtk.module" OUTPUT_VARIABLE module_files)

vtk_module_scan(
  MODULE_FILES ${module_files}
  REQUEST_MODULES ${python_modules} ${paraview_modules}
  PROVIDES_MODULES modules
  HIDE_MODULES_FROM_CACHE ON)

vtk_module_build(
  MODULES ${modules}
  PACKAGE SurfaceGeodesics
  INSTALL_EXPORT SurfaceGeodesics
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/surfacegeodesics"
  CMAKE_DESTINATION "${module_cmake_directory}"
  ENABLE_WRAPPING ON)

vtk_module_wrap_python(
  MODULES ${python_modules}
  TARGET SurfaceGeodesics::Python
  PYTHON_PACKAGE surfacegeodesics
  MODULE_DESTINATION "${python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_HEADERS OFF)

foreach (file IN ITEMS __init__.py measure.py py.typed)
  configure_file("Plugin/Python/surfacegeodesics/${file}" "${python_package_directory}/${file}" COPYONLY)
  install(FILES "Plugin/Python/surfacegeodesics/${file}"
    DESTINATION "${python_package_directory}"
    COMPONENT python)
endforeach ()
