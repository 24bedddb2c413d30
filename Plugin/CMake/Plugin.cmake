# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# The ParaView plugin, and the surfacegeodesics.plugins.xml by which ParaView loads it.

# ParaView's documentation of a plugin is made with Qt's tools and shown by its Qt client.
if (NOT SURFACEGEODESICS_USE_QT)
  set(PARAVIEW_USE_QT OFF)
endif ()

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)

paraview_plugin_build(
  PLUGINS ${plugins}
  AUTOLOAD ${plugins}
  PLUGINS_FILE_NAME surfacegeodesics.plugins.xml
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")

# build/<preset>/plugins, so that scripts and people need not know ParaView's version.
file(CREATE_LINK "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}" "${PROJECT_BINARY_DIR}/plugins" SYMBOLIC)
