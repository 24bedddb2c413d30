#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Builds what needs no ParaView on Debian's VTK, as Plugin/Documentation/tracing.md says, installs it into a folder of
# its own and uses it there.
# usage: bash Testing/Install/vtk_alone.sh FOLDER      (as root; Debian's ParaView must not be there)
set -euo pipefail
folder=$(realpath -m "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
packages=$(sed -n 's/^    apt-get install \(libvtk9-dev .*\)/\1/p' Plugin/Documentation/tracing.md)
apt-get update
# shellcheck disable=SC2086
apt-get install -y --no-install-recommends $packages
cmake --preset vtk
cmake --build --preset vtk
cmake --install build/vtk --prefix "$folder"
"$folder/bin/MakeEllipsoid" "$folder/Ellipsoid.vtp"
package=$(find "$folder/lib" -type d -name surfacegeodesics -path '*packages*')
PYTHONPATH=${package%/*} python3 Plugin/Examples/plain_vtk.py
