# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances and a path on a sphere with VTK and numpy alone, beside the true values.

usage: python3 plain_vtk.py      (with the package surfacegeodesics in PYTHONPATH)
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource

import surfacegeodesics

source = vtkSphereSource()
source.SetRadius(1)
source.SetThetaResolution(128)
source.SetPhiResolution(128)
source.Update()
sphere = source.GetOutput()
points = vtk_to_numpy(sphere.GetPoints().GetData())

distances = surfacegeodesics.distance(sphere, [[0, 0, 1]])
truth = np.arccos(np.clip(points[:, 2], -1, 1))
print(f"{len(distances)} distances, the largest error is {abs(distances - truth).max():.4f}")
assert abs(distances - truth).max() < 0.01

line, length = surfacegeodesics.path(sphere, [[0, 0, 1], [1, 0, 0], [0, 1, 0]], method="Exact")
print(f"The path has {line.GetNumberOfPoints()} points and the length {length:.4f}, on the true sphere {np.pi:.4f}")
assert abs(length - np.pi) < 0.001
