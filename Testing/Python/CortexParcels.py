# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the example CortexParcels.py and checks the files that it writes.

usage: CortexParcels.py OUR_PLUGIN EXAMPLE
"""

import csv
import os
import runpy
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

plugin, example = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder:
    sys.argv = [example, plugin, folder]
    runpy.run_path(example, run_name="__main__")
    with open(os.path.join(folder, "Parcels.csv"), encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(folder, "Parcels.vtp"))
    reader.Update()
    surface = reader.GetOutput()

points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
cells = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
nearest = vtk_to_numpy(surface.GetPointData().GetArray("NearestSeed"))
distance = vtk_to_numpy(surface.GetPointData().GetArray("GeodesicDistance"))
a, b, c = (points[cells[:, i]] for i in range(3))
area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
assert len(rows) == 7
# The parcels cover the surface once. A third of a triangle belongs to each of its corners.
areas = np.array([float(row["Area"]) for row in rows])
assert np.isclose(areas.sum(), area.sum(), rtol=1e-6), (areas.sum(), area.sum())
assert np.allclose(areas, np.bincount(nearest[cells].ravel(), np.repeat(area / 3, 3)), rtol=1e-5)
assert np.allclose([float(row["LargestDistance"]) for row in rows], [distance[nearest == seed].max() for seed in range(7)])
# The parcels of the seeds beside the seventh are smaller than those of the seeds opposite to it.
assert areas[[0, 2, 4]].max() < areas[[1, 3, 5]].min(), areas
