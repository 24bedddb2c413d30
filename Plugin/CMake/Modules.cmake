# The VTK modules and the Python package of their classes. They are built outside the plugin, so that
# only the classes that its XML names are wrapped for the client-server interpreter.

set(BUILD_SHARED_LIBS ON)

set(module_cmake_directory "${CMAKE_INSTALL_LIBDIR}/cmake/SurfaceGeodesics")
set(python_package_directory "${PARAVIEW_PYTHONPATH}/surfacegeodesics")

vtk_module_scan(
  MODULE_FILES
    "${PROJECT_SOURCE_DIR}/Filters/Geodesics/vtk.module"
    "${PROJECT_SOURCE_DIR}/Filters/Surface/vtk.module"
  REQUEST_MODULES
    SurfaceGeodesics::FiltersGeodesics
    SurfaceGeodesics::FiltersSurface
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
  MODULE_DESTINATION "${PARAVIEW_PYTHONPATH}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_HEADERS OFF)

set(python_package_file "Plugin/Python/surfacegeodesics/__init__.py")
configure_file("${python_package_file}" "${python_package_directory}/__init__.py" COPYONLY)
install(FILES "${python_package_file}" DESTINATION "${python_package_directory}")
