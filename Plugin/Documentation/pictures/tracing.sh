#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Draws the pictures of tracing.md in this folder: those of scenarios.sh, trimmed and with fewer colours.
# usage: bash tracing.sh      (after Plugin/demo.sh, or with BUILD; needs imagemagick and xvfb)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
project="$PWD/../../.."
drawn=$(mktemp -d)
trap 'rm -r "$drawn"' EXIT

PATH=${BUILD:-$project/build/release}/bin:$PATH
bash "$project/Widgets/Tracing/Examples/scenarios.sh" "$project/Testing/Data/Bunny.vtp" "$drawn"
for picture in "$drawn"/*.png; do
  convert "$picture" -trim +repage -bordercolor white -border 8 -resize 520x -colors 128 -strip \
    -define png:compression-level=9 "PNG8:tracing-$(basename "$picture")"
done
