# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# The VTK modules and the Python package of their classes. They are built outside the plugin, so that
# only the classes that its XML names are wrapped for the client-server interpreter.

if (NOT SURFACEGEODESICS_BUILD_PLUGIN)
  vtk_module_python_default_destination(python_destination)
else ()
  set(python_destination "${PARAVIEW_PYTHONPATH}")
endif ()

set(BUILD_SHARED_LIBS ON)

set(module_cmake_directory "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceGeodesics")
set(python_package_directory "${python_destination}/surfacegeodesics")

vtk_module_scan(
  MODULE_FILES
    "${PROJECT_SOURCE_DIR}/Filters/Geodesics/vtk.module"
    "${PROJECT_SOURCE_DIR}/Filters/Surface/vtk.module"
    "${PROJECT_SOURCE_DIR}/Widgets/Tracing/vtk.module"
  REQUEST_MODULES
    SurfaceGeodesics::FiltersGeodesics
    SurfaceGeodesics::FiltersSurface
    SurfaceGeodesics::WidgetsTracing
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
  MODULES ${modules}
  TARGET SurfaceGeodesics::Python
  PYTHON_PACKAGE surfacegeodesics
  MODULE_DESTINATION "${python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_HEADERS OFF)

set(python_package_file "Plugin/Python/surfacegeodesics/__init__.py")
configure_file("${python_package_file}" "${python_package_directory}/__init__.py" COPYONLY)
install(FILES "${python_package_file}" DESTINATION "${python_package_directory}")
