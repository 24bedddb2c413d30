# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two blocks, a unit square each, whose global ids neither an int nor a double holds: from 2^60 + 1 on."""

from paraview.simple import *

SQUARES = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource

output = self.GetOutput()
for i in range(2):
    plane = vtkPlaneSource()
    plane.SetCenter(0, 0, i)
    plane.Update()
    ids = numpy_to_vtkIdTypeArray(2**60 + 1 + np.arange(4 * i, 4 * i + 4), deep=True)
    ids.SetName("GlobalPointIds")
    plane.GetOutput().GetPointData().SetGlobalIds(ids)
    output.SetBlock(i, plane.GetOutput())
"""

ProgrammableSource(registrationName="LargeIds", OutputDataSetType="vtkMultiblockDataSet", Script=SQUARES)
