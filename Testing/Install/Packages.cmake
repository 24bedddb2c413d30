# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Makes the packages of the build of BUILD_DIRECTORY in FOLDER.
file(REMOVE_RECURSE "${FOLDER}")
execute_process(
  COMMAND "${CMAKE_CPACK_COMMAND}" --config "${BUILD_DIRECTORY}/CPackConfig.cmake" -C "${CONFIGURATION}" -B "${FOLDER}"
  COMMAND_ERROR_IS_FATAL ANY)
