#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Draws distance-bands.png in this folder: ParaView's window with distances on the Bunny in bands.
# usage: bash distance-bands.sh      (after Plugin/demo.sh; needs imagemagick and xvfb)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
project="$PWD/../../.."
settings=$(mktemp -d)
trap 'rm -r "$settings"' EXIT

export XDG_CONFIG_HOME=$settings
export PV_PLUGIN_CONFIG_FILE=${PV_PLUGIN_CONFIG_FILE:-$project/build/release/lib/paraview-5.11/plugins/surfacegeodesics.plugins.xml}
xvfb-run -a -s "-screen 0 1366x920x24" paraview -qwindowgeometry 1366x920+0+0 --dr \
  "--data-directory=$project/Testing/Data" "--test-directory=$PWD" "--test-script=$PWD/distance-bands.xml" --exit
