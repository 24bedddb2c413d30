# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# What every part of the project is built with.

include(GNUInstallDirs)
# The component of what is installed without naming one.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "The kind of build" FORCE)
endif ()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# ParaView opens plugins RTLD_GLOBAL: what is not exported cannot collide with another plugin.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

# The build tree has the layout of the installed tree.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

# Linked PRIVATE by our own targets, so that the generated wrapping code is compiled without it.
add_library(geodesics_warnings INTERFACE)
# GCC takes sources that a unity build includes for headers.
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(wrong_if_united $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-subobject-linkage>)
endif ()
target_compile_options(geodesics_warnings INTERFACE
  -Wall -Wextra ${wrong_warnings} ${wrong_if_united}
  $<$<BOOL:${SURFACEGEODESICS_WARNINGS_AS_ERRORS}>:-Werror>)
