#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# The Debian packages of this project for each ParaView that a Debian has, and how to install those that are missing. To
# be sourced.
# shellcheck shell=bash

# For what (build: building the plugin and running it without a display; test: the tests and the checks of the sources
# beside that), the versions of ParaView that need it, the package, and what it provides where packages have other names.
package_table='
build  all       cmake                     CMake 3.25 or later
build  all       g++                       GCC 12 or later
build  all       libdouble-conversion-dev  double-conversion
build  all       libfreetype-dev           FreeType
build  all       libglew-dev               GLEW
build  all       libhdf5-openmpi-dev       HDF5 for MPI
build  all       libnetcdf-dev             NetCDF
build  all       mpi-default-bin           mpiexec
build  all       mpi-default-dev           MPI for C++
build  all       ninja-build               Ninja
build  all       paraview-dev              ParaView 5.11 to 6.1 for developers
build  all       python3-dev               the headers of ParaView'\''s Python
build  all       python3-paraview          pvpython
build  all       xauth                     xauth
build  all       xvfb                      xvfb-run
build  5.11      libqt5opengl5-dev         Qt 5 OpenGL
build  5.11      libqt5svg5-dev            Qt 5 SVG
build  5.11      qtbase5-dev               Qt 5
build  5.11      qttools5-dev              Qt 5 Help
build  5.11      qtxmlpatterns5-dev-tools  xmlpatterns
build  5.13,6.1  qt6-5compat-dev           Qt 6 Core5Compat
build  5.13,6.1  qt6-base-dev              Qt 6
build  5.13,6.1  qt6-svg-dev               Qt 6 SVG
build  5.13,6.1  qt6-svg-plugins           Qt 6 icons in SVG
build  5.13,6.1  qt6-tools-dev             Qt 6 Help
build  6.1       libvtk9-dev               VTK 9.6 for developers
build  6.1       libvtk9-qt-dev            VTK 9.6 for Qt
build  6.1       xsltproc                  xsltproc
test   all       ccache                    ccache
test   all       clang                     Clang
test   all       gdb                       gdb
test   all       imagemagick               ImageMagick
test   all       libbenchmark-dev          Google Benchmark
test   all       libcgal-dev               CGAL
test   all       libclang-rt-dev           Clang'\''s sanitizers
test   all       libeigen3-dev             Eigen
test   all       libgmp-dev                GMP
test   all       libgtest-dev              GoogleTest
test   all       libmpfr-dev               MPFR
test   all       python3-pip               pip
test   all       xdotool                   xdotool
test   5.11      clang-format-14           clang-format 14
test   5.11      clang-tidy-14             clang-tidy 14
'

# The version of ParaView that is installed or can be installed, as a column of the table; empty if there is none.
paraview_version()
{
  local version
  version=$(dpkg-query -W -f '${Version}' paraview-dev 2>/dev/null) ||
    version=$(apt-cache policy paraview-dev 2>/dev/null | sed -n 's/^ *Candidate: //p')
  case $version in
    5.11.*) echo 5.11 ;;
    5.13.*) echo 5.13 ;;
    6.1.*) echo 6.1 ;;
  esac
}

# packages_for KIND VERSION
packages_for()
{
  awk -v kind="$1" -v version="$2" '$1 == kind && ("," $2 ",") ~ (",(all|" version "),") { print $3 }' \
    <<<"$package_table"
}

as_root()
{
  if ((EUID == 0)); then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "Not root and no sudo, so this cannot be run: $*" >&2
    return 1
  fi
}

# Says what is needed where the names of the packages are not known.
tell_what_to_provide()
{
  local kind
  echo "This system has no packages of ParaView 5.11, 5.13 or 6.1 that are known here, so nothing is installed."
  echo "What has to be there:"
  for kind in "$@"; do
    awk -v kind="$kind" '
      $1 == kind { only = $2 == "all" ? "" : " (for ParaView " $2 ")"; $1 = $2 = $3 = ""; sub(/^ +/, ""); print "  " $0 only }
    ' <<<"$package_table"
  done
  echo "A ParaView in a folder of its own is found by CMAKE_PREFIX_PATH=FOLDER in the environment."
}

# install_packages KIND...
# Installs what is missing. On a system whose packages are not known it says what is needed, and goes on if at least
# CMake, Ninja and ParaView are there.
install_packages()
{
  local version package kind missing=()
  version=$(paraview_version)
  if [[ -z $version ]] && command -v apt-get >/dev/null; then
    as_root apt-get update
    version=$(paraview_version)
  fi
  if [[ -z $version ]]; then
    tell_what_to_provide "$@" >&2
    command -v cmake ninja pvpython | awk 'END { exit NR != 3 }'
    return
  fi
  for kind in "$@"; do
    for package in $(packages_for "$kind" "$version"); do
      [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == *" installed" ]] || missing+=("$package")
    done
  done
  if ((${#missing[@]})); then
    as_root apt-get update
    as_root env DEBIAN_FRONTEND=noninteractive \
      apt-get install --yes --no-install-recommends "${missing[@]}"
  fi
}
