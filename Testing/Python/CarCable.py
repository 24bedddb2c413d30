# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the example CarCable.py. Its body can be laid flat, so that the lengths follow from its profile.

usage: CarCable.py OUR_PLUGIN EXAMPLE
"""

import contextlib
import io
import os
import re
import runpy
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

plugin, example = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
    sys.argv = [example, plugin, folder]
    runpy.run_path(example, run_name="__main__")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(folder, "Cable.vtp"))
    reader.Update()
    points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype(float)
length, straight = (float(text) for text in re.findall(r": ([\d.]+) m", printed.getvalue()))

# The profile as the mesh has it: straight between its 211 columns.
columns = np.linspace(0, 4.2, 211)
heights = 0.7 + 0.1 * columns + 0.5 * np.clip((columns - 1.1) / 0.7, 0, 1) - 0.45 * np.clip((columns - 3) / 0.6, 0, 1)
along = np.concatenate([[0], np.cumsum(np.hypot(np.diff(columns), np.diff(heights)))])


def flat(x, y):
    """A point of the body laid flat."""
    return np.array([np.interp(x, columns, along), y])


def length_of(*route):
    return sum(np.linalg.norm(b - a) for a, b in zip(route, route[1:]))


battery, clip, rear = flat(0.3, -0.5), flat(0.9, -0.2), flat(3.8, 0.1)
# Coordinates are in single precision.
assert abs(straight - length_of(battery, clip, rear)) < 2e-6, straight
# Points of the sunroof lie from x = 2.02 to 2.58 and from y = -0.39 on, and faces with such a corner are closed. Squares
# are cut from their corner of least x and y, so that the open faces end at these two points.
assert abs(length - length_of(battery, clip, flat(2.0, -0.41), flat(2.58, -0.41), rear)) < 2e-6, length
assert not ((np.abs(points[:, 0] - 2.3) < 0.299) & (np.abs(points[:, 1]) < 0.399)).any()
