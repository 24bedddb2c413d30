#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Builds the plugin and runs Plugin/Examples/BunnyDistance.py with it, from a bare Debian 12, 13 or sid.
# usage: bash Plugin/demo.sh      (as root, or with sudo where packages are missing)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Plugin/packages.sh
install_packages build

SECONDS=0
cmake --preset release
cmake --build --preset release
build_seconds=$SECONDS

display=()
if [[ -z ${DISPLAY:-} ]]; then
  display=(xvfb-run -a)
fi
plugins="$PWD/build/release/plugins"
mkdir -p build/demo
echo
echo "Build: $build_seconds s"
"${display[@]}" pvpython Plugin/Examples/BunnyDistance.py \
  "$plugins/SurfaceGeodesics/SurfaceGeodesics.so" Testing/Data/Bunny.vtp build/demo

cat <<END

To look at the result in ParaView:
  paraview $PWD/build/demo/BunnyDistance.vtp
To work with the filter (Filters > Surface Geodesics > Geodesic Distance):
  PV_PLUGIN_CONFIG_FILE=$plugins/surfacegeodesics.plugins.xml \\
    paraview $PWD/Testing/Data/Bunny.vtp
END
