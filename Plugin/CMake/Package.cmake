# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# What find_package(SurfaceGeodesics) reads.

include(CMakePackageConfigHelpers)

configure_file(Plugin/CMake/SurfaceGeodesicsConfig.cmake.in
  "${module_cmake_directory}/SurfaceGeodesicsConfig.cmake" @ONLY)
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/${module_cmake_directory}/SurfaceGeodesicsConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
configure_file(Plugin/CMake/Versions.cmake "${module_cmake_directory}/Versions.cmake" COPYONLY)
install(
  FILES
    "${PROJECT_BINARY_DIR}/${module_cmake_directory}/SurfaceGeodesicsConfig.cmake"
    "${PROJECT_BINARY_DIR}/${module_cmake_directory}/SurfaceGeodesicsConfigVersion.cmake"
    Plugin/CMake/Versions.cmake
  DESTINATION "${module_cmake_directory}"
  COMPONENT development)
