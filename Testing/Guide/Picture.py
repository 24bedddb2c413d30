# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script draws its picture, and it looks like the one in the guide.

usage: pvpython Picture.py SCRIPT DATA PICTURE NEW

Other versions of ParaView draw other fonts, backgrounds and shades, so that the middle of the pictures is compared, in cells of
20 x 20 pixels: on average they differ by less than a tenth of the range. An empty view or another surface differs by more.
"""

import runpy
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

script, data, picture, new = sys.argv[1:]
CELL = 20


def cells_of(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[..., :3] / 255.0
    height, width = height // CELL, width // CELL
    return pixels[: height * CELL, : width * CELL].reshape(height, CELL, width, CELL, 3).mean(axis=(1, 3))


sys.argv = [script, data, new]
runpy.run_path(script, run_name="__main__")
before, after = cells_of(picture), cells_of(new)
assert before.shape == after.shape, (before.shape, after.shape)
assert after.std() > 0.05, "The picture is blank"
difference = abs(before - after).mean()
print(f"Mean difference of cells: {difference:.4f}")
assert difference < 0.1, difference
