# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The property Signed of the proxy GeodesicDistance, and the example of a dam line.

usage: SignedDistance.py OUR_PLUGIN DAM_LINE.py
"""

import runpy
import sys

import numpy as np
from paraview import simple

import testing

plugin, example = sys.argv[1:]
testing.load(plugin)

# The square [-0.5, 0.5]^2.
plane = simple.Plane(XResolution=40, YResolution=40)
points = testing.points_of(plane)
angles = np.linspace(0, 2 * np.pi, 60, endpoint=False) + 0.01
loop = testing.polyline(np.stack([0.3 * np.cos(angles), 0.3 * np.sin(angles), 0 * angles], axis=1), closed=True)
distance = simple.GeodesicDistance(Input=plane, SeedSource=loop)
assert distance.Signed == 0
magnitude = testing.array_of(distance).copy()
assert magnitude.min() >= 0
distance.Signed = 1
found = testing.array_of(distance)
radius = np.linalg.norm(points, axis=1)
np.testing.assert_array_equal(np.abs(found), magnitude)
away = np.abs(radius - 0.3) > 1e-3
np.testing.assert_array_equal(found[away] < 0, radius[away] < 0.3)
# In the middle the fronts of all sides meet.
np.testing.assert_allclose(found, radius - 0.3, atol=0.02)

# From right to left: the left is below.
distance.SeedSource = testing.polyline([[0.5, 0.113, 0], [-0.5, 0.113, 0]])
np.testing.assert_allclose(testing.array_of(distance), 0.113 - points[:, 1], atol=1e-6)
distance.SeedSource = testing.polyline([[0.5, 0.113, 0], [-0.4, 0.113, 0]])
testing.expect_error(distance, "SeedSource's line 0", "open", "Signed")
distance.SeedSource = loop
distance.SeedPositions = [0, 0, 0]
testing.expect_error(distance, "seed 0 is not a line", "turn Signed off")
distance.SeedPositions = []
distance.UnreachedAs = "Value"
testing.expect_error(distance, "UnreachedValue is -1", "NaN")

# The example: the water side of the dam has the other sign than the valley below it, and the curves are offset ones.
dam = runpy.run_path(example, run_name="test")
values = testing.array_of(dam["distance"])
assert values.min() < -1 and values.max() > 1
offsets = testing.output_of(dam["offsets"])
levels = testing.vtk_to_numpy(offsets.GetPointData().GetArray("GeodesicDistance"))
assert set(np.round(levels, 6)) == {-0.5, 0.5}
