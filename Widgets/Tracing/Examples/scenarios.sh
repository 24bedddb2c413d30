#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs the scenarios of the article's section 3 and has each make its picture.
# usage: scenarios.sh BUNNY.vtp FOLDER      with the two programs and MakeEllipsoid in PATH
set -euo pipefail
(($# == 2)) || { sed -n '3s/^# //p' "$0" >&2; exit 1; }
bunny=$1
folder=$2
events=$(dirname "${BASH_SOURCE[0]}")/events
mkdir -p "$folder"

run()
{
  if [[ -z ${DISPLAY:-} ]]; then
    xvfb-run -a "$@"
  else
    "$@"
  fi
}

echo "Distance"
run GeodesicDistanceExample "$bunny" "$folder/distance.vtp" --seed 17857 --screenshot "$folder/distance.png"

echo "Distance up to a maximum"
run GeodesicDistanceExample "$bunny" "$folder/maximum.vtp" --maxDist 0.08 --seed 17857 \
  --screenshot "$folder/maximum.png"

echo "Distance with curvature as cost"
MakeEllipsoid "$folder/Ellipsoid.vtp"
run GeodesicDistanceExample "$folder/Ellipsoid.vtp" "$folder/weights.vtp" --propagationWts Curvature \
  --seed 3582 --screenshot "$folder/weights.png"

echo "Distance within a contour: the Bunny's head"
run GeodesicDistanceExample "$bunny" "$folder/head.vtp" --exclusionContour --events "$events/neck.events" \
  --screenshot "$folder/head.png"

echo "Paths by Dijkstra's algorithm and by fast marching"
run GeodesicPathExample "$bunny" 0 0 0.0005 --events "$events/round.events" --screenshot "$folder/dijkstra.png"
run GeodesicPathExample "$bunny" 1 1 0.0005 --events "$events/round.events" --screenshot "$folder/fast-marching.png"
