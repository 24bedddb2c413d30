# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# What cpack makes: Debian packages where ParaView is Debian's, and a .tar.gz everywhere.

set(documentation_directory "${CMAKE_INSTALL_DATADIR}/doc/paraview-surfacegeodesics")
install(FILES LICENSE DESTINATION "${documentation_directory}" RENAME copyright COMPONENT runtime)
install(DIRECTORY Plugin/Documentation/ DESTINATION "${documentation_directory}"
  COMPONENT runtime
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.gif" PATTERN "*.cff")
install(DIRECTORY Plugin/Examples DESTINATION "${documentation_directory}" COMPONENT runtime)
# What the guide shows.
install(DIRECTORY Testing/Data DESTINATION "${documentation_directory}" COMPONENT runtime)
foreach (package IN ITEMS python3-surfacegeodesics libsurfacegeodesics-dev)
  set(component development)
  if (package MATCHES "^python3")
    set(component python)
  endif ()
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" RENAME copyright COMPONENT ${component})
endforeach ()

# ParaView loads what lies in the folder "plugins" beside its programs. It is the only place where both 5.11 and 5.13 of
# Debian look by themselves: 5.11 does not find its own paraview.plugins.xml, and a variable is not set everywhere.
if (SURFACEGEODESICS_BUILD_PLUGIN)
  file(RELATIVE_PATH plugin_folder
    "${CMAKE_INSTALL_FULL_BINDIR}/plugins"
    "${CMAKE_INSTALL_FULL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/SurfaceGeodesics")
  set(link "${PROJECT_BINARY_DIR}/autoload/SurfaceGeodesics")
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/autoload")
  file(CREATE_LINK "${plugin_folder}" "${link}" SYMBOLIC)
  install(FILES "${link}" DESTINATION "${CMAKE_INSTALL_BINDIR}/plugins" COMPONENT runtime)
endif ()

set(CPACK_GENERATOR TGZ)
if (paraview_is_debians)
  list(PREPEND CPACK_GENERATOR DEB)
endif ()
set(CPACK_PACKAGE_NAME surfacegeodesics)
set(CPACK_PACKAGE_CONTACT "SurfaceGeodesics authors")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL runtime development python)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME paraview-surfacegeodesics)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsurfacegeodesics-dev)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-surfacegeodesics)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}: the plugin for ParaView")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION}: headers, CMake files and programs")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}: the Python package")

# A build works with the ParaView that it was made with.
math(EXPR next_minor_number "${ParaView_VERSION_MINOR} + 1")
set(paraview_range ">= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
set(paraview_below "<< ${ParaView_VERSION_MAJOR}.${next_minor_number}~")
set(same_version "paraview-surfacegeodesics (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "paraview (${paraview_range}), paraview (${paraview_below})")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "python3-paraview")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${same_version}, paraview-dev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_version}, python3-paraview, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/Plugin/CMake/debian/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)

include(CPack)
