# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""distance() and path() of the package surfacegeodesics, in a Python without ParaView: values, options and mistakes."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource

from surfacegeodesics import distance, path

source = vtkPlaneSource()
source.SetResolution(10, 10)
source.Update()
plane = source.GetOutput()
points = vtk_to_numpy(plane.GetPoints().GetData()).astype(float)

# A plane's distances are straight, to single precision of its points. Seeds lie anywhere in faces.
seeds = np.array([[0.123, 0.045, 0], [-0.4, -0.33, 0]])
truth = np.linalg.norm(points[:, None] - seeds, axis=2).min(axis=1)
for method in ("FastMarching", "Exact", "VirtualSources"):
    assert abs(distance(plane, seeds, method=method) - truth).max() < 1e-6, method
assert (distance(plane, seeds, method="Dijkstra") >= truth - 1e-6).all()
bounded = distance(plane, seeds, method="Bounded")
assert (bounded >= truth - 1e-6).all() and (bounded <= truth * 1.001 + 1e-6).all()

# One position, point ids, a stop and a cost.
assert abs(distance(plane, seeds[0]) - np.linalg.norm(points - seeds[0], axis=1)).max() < 1e-6
assert abs(distance(plane, [0]) - np.linalg.norm(points - points[0], axis=1)).max() < 1e-6
near = distance(plane, [0], maximum=0.5)
assert np.isnan(near).any() and np.nanmax(near) <= 0.5
cost = numpy_to_vtk(np.full(len(points), 3.0), deep=True)
cost.SetName("Cost")
plane.GetPointData().AddArray(cost)
assert abs(distance(plane, [0], cost="Cost") - 3 * distance(plane, [0])).max() < 1e-5
# The surface stays as it was.
assert plane.GetPointData().GetNumberOfArrays() == 3

triangle = [[-0.3, -0.3, 0], [0.3, -0.3, 0], [0.3, 0.3, 0]]
line, length = path(plane, triangle)
assert abs(length - 1.2) < 1e-6 and line.GetNumberOfLines() == 2
line, length = path(plane, triangle, closed=True)
assert abs(length - (1.2 + 0.6 * np.sqrt(2))) < 1e-6 and line.GetNumberOfLines() == 3

for mistake, words in (
        (lambda: distance(plane, [10000]), "10000"),
        (lambda: distance(plane, [[1.0, 2.0]]), "(1, 2)"),
        (lambda: distance(plane, [0], method="Fast"), "Exact"),
        (lambda: distance(plane, [0], cost="Price"), "Price"),
        (lambda: distance(plane, [0], method="Exact", cost="Cost"), "FastMarching"),
        (lambda: path(plane, triangle[:1]), "at least two")):
    try:
        mistake()
    except ValueError as error:
        assert words in str(error), error
    else:
        raise AssertionError(words)
