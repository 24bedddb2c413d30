# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs the build of BUILD_DIRECTORY to FIRST_PREFIX and moves that to PREFIX.
file(REMOVE_RECURSE "${FIRST_PREFIX}" "${PREFIX}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIRECTORY}" --prefix "${FIRST_PREFIX}"
    --config "${CONFIGURATION}"
  COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${FIRST_PREFIX}" "${PREFIX}")
