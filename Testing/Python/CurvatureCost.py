# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example CurvatureCost.py: curvature by the formula, and the field of a four times finer mesh.

usage: CurvatureCost.py OUR_PLUGIN EXAMPLE
"""

import os
import runpy
import sys
import tempfile

import numpy as np
from paraview import simple

import testing

plugin, example = sys.argv[1:3]
testing.load(plugin)

AXES = np.array([1, 0.7, 0.5])


def mean_curvature(points):
    """Of the ellipsoid of these half axes: (sum a_i^2 - |p|^2) / (2 (a b c)^2 |p / a^2|^3)."""
    steepness = np.linalg.norm(points / AXES**2, axis=1)
    return (np.sum(AXES**2) - np.sum(points**2, axis=1)) / (2 * np.prod(AXES) ** 2 * steepness**3)


with tempfile.TemporaryDirectory() as folder:
    sys.argv = [example, plugin, folder]
    runpy.run_path(example)
    written = simple.XMLPolyDataReader(FileName=os.path.join(folder, "CurvatureCost.vtp"))
    points = testing.points_of(written).astype(float)
    cost, found = testing.array_of(written, "Cost"), testing.array_of(written)

# ParaView's curvature is rough in the narrow triangles at the sphere's poles only.
error = np.abs(cost / (mean_curvature(points) + 0.01) - 1)
assert np.mean(error < 0.01) > 0.97, np.mean(error < 0.01)

# The coarse mesh's points are among the fine one's.
sphere = simple.Sphere(Radius=1, ThetaResolution=4 * 128, PhiResolution=4 * 127 + 1)
ellipsoid = simple.Transform(Input=sphere)
ellipsoid.Transform.Scale = AXES.tolist()
fine = testing.with_arrays(
    ellipsoid, points={"cost": mean_curvature(testing.points_of(ellipsoid).astype(float)) + 0.01})
distance = simple.GeodesicDistance(
    Input=fine, SeedPositions=[1, 0, 0], CostArray=["POINTS", "cost"])
truth, surface = testing.array_of(distance), testing.output_of(distance)
truth = truth[[surface.FindPoint(point) for point in points]]
assert np.mean(np.abs(found - truth)) < 5e-3 * truth.max(), np.mean(np.abs(found - truth)) / truth.max()
