# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin that PV_PLUGIN_CONFIG_FILE names and the package in PYTHONPATH work, and all that they
load of ours is below one prefix.

usage: InstalledPlugin.py PREFIX
"""

import sys

from paraview import simple
import surfacegeodesics


def loaded_libraries(marker):
    with open("/proc/self/maps", encoding="utf-8") as maps:
        paths = {line.split()[-1] for line in maps}
    return {path for path in paths if marker in path.rpartition("/")[2]}


prefix = sys.argv[1]
distance = simple.GeodesicDistance(Input=simple.Sphere(), SeedPositions=[0, 0, 0.5])
distance.UpdatePipeline()
assert distance.PointData["GeodesicDistance"] is not None
assert type(distance.GetClientSideObject()) is surfacegeodesics.vtkSurfaceGeodesicDistance

ours = loaded_libraries("Geodesics")
assert any(path.endswith("/SurfaceGeodesics.so") for path in ours)
assert all(path.startswith(prefix + "/") for path in ours), ours
