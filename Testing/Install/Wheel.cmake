# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# pip builds the wheel in BUILD, installs it in FOLDER, and SCRIPT runs with it. ARGUMENTS are those of CMAKE_ARGS.
file(REMOVE_RECURSE "${FOLDER}")
set(ENV{CMAKE_ARGS} "${ARGUMENTS}")
set(pip "${PYTHON}" -m pip --disable-pip-version-check)
execute_process(
  COMMAND ${pip} wheel --no-index --no-deps "--config-settings=build-dir=${BUILD}"
    --wheel-dir "${FOLDER}/wheel" "${SOURCE}"
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB wheel "${FOLDER}/wheel/surfacegeodesics-*.whl")
execute_process(
  COMMAND ${pip} install --no-index --no-deps --target "${FOLDER}/site" "${wheel}"
  COMMAND_ERROR_IS_FATAL ANY)
# The package alone has to do: it must not be found in the build.
set(ENV{PYTHONPATH} "${FOLDER}/site")
execute_process(
  COMMAND "${PYTHON}" "${SCRIPT}"
  COMMAND_ERROR_IS_FATAL ANY)
