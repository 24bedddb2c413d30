# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""How alike two pictures are, in cells of 20 x 20 pixels, so that fonts and edges count little.

usage: python3 likeness.py OLD NEW SHARE      (fails if more than this share of the cells differs)
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

CELL = 20
# Other words change a cell by more than this, in parts of the range. A hint of two lines that changed was 16 of 2,584 cells.
VISIBLE = 0.01


def cells_of(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[..., :3] / 255.0
    height, width = height // CELL, width // CELL
    return pixels[: height * CELL, : width * CELL].reshape(height, CELL, width, CELL, 3).mean(axis=(1, 3))


def differences(old, new):
    """Of each cell, the mean over its colours."""
    before, after = cells_of(old), cells_of(new)
    assert before.shape == after.shape, (before.shape, after.shape)
    assert after.std() > 0.05, "The picture is blank"
    return abs(before - after).mean(axis=2)


if __name__ == "__main__":
    # Without the status bar of ParaView's window, which shows the memory in use. VTK's rows begin at the bottom.
    STATUS_BAR = 2
    seen = (differences(sys.argv[1], sys.argv[2])[STATUS_BAR:] > VISIBLE).mean()
    print(f"Cells that differ: {seen:.4f}")
    assert seen <= float(sys.argv[3]), f"{sys.argv[1]} shows something else than {sys.argv[2]}: draw it again by draw.sh"
