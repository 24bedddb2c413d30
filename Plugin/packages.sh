# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# The Debian 12 packages of this project, and how to install those that are missing. To be sourced.
# shellcheck shell=bash disable=SC2034

# What building the plugin and running it without a display needs.
build_packages=(
  cmake
  g++
  libdouble-conversion-dev
  libfreetype-dev
  libglew-dev
  libhdf5-openmpi-dev
  libnetcdf-dev
  libqt5opengl5-dev
  libqt5svg5-dev
  mpi-default-bin
  mpi-default-dev
  ninja-build
  paraview-dev
  python3-dev
  python3-paraview
  qtbase5-dev
  qttools5-dev
  qtxmlpatterns5-dev-tools
  xauth
  xvfb
)

# What the tests and the checks of the sources need beside that.
test_packages=(
  ccache
  clang-14
  clang-format-14
  clang-tidy-14
  imagemagick
  libbenchmark-dev
  libcgal-dev
  libeigen3-dev
  libgmp-dev
  libgtest-dev
  libmpfr-dev
  xdotool
)

as_root()
{
  if ((EUID == 0)); then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "Not root and no sudo, so these cannot be installed: ${missing[*]}" >&2
    return 1
  fi
}

# install_missing PACKAGE...
install_missing()
{
  local package missing=()
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == *" installed" ]] || missing+=("$package")
  done
  if ((${#missing[@]})); then
    as_root apt-get update
    as_root env DEBIAN_FRONTEND=noninteractive \
      apt-get install --yes --no-install-recommends "${missing[@]}"
  fi
}
