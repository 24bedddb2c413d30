#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Draws pictures in this folder: NAME.png, or NAME.gif where it moves, of ParaView's window as NAME.xml plays it, or as NAME.py draws it in pvpython.
# usage: bash draw.sh [NAME...]      (after Plugin/demo.sh; needs imagemagick and xvfb)
# Without a name all of them are drawn. FOLDER is where they go, if not here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
project="$PWD/../../.."
settings=$(mktemp -d)
trap 'rm -r "$settings"' EXIT

export PV_PLUGIN_CONFIG_FILE=${PV_PLUGIN_CONFIG_FILE:-$project/build/release/plugins/surfacegeodesics.plugins.xml}
scripts=(*.xml *.py)
names=("${@:-${scripts[@]%.*}}")
for name in "${names[@]}"; do
  suffix=png
  [[ $name != live-drag ]] || suffix=gif
  picture=${FOLDER:-$PWD}/$name.$suffix
  if [[ -e $name.py ]]; then
    XDG_CONFIG_HOME=$settings xvfb-run -a pvpython "$name.py" "$project/Testing/Data" "$picture"
    continue
  fi
  height=768
  # The check box of bands is low in the panel.
  [[ $name != distance-bands ]] || height=920
  # Told that it is tested, ParaView asks nothing back when the session is reset.
  DASHBOARD_TEST_FROM_CTEST=1 XDG_CONFIG_HOME=$settings/$name PICTURE=$picture \
    xvfb-run -a -s "-screen 0 1366x${height}x24" paraview -qwindowgeometry 1366x$height+0+0 --dr \
    "--data-directory=$project/Testing/Data" "--test-directory=$settings" "--test-script=$PWD/$name.xml" --exit
done
