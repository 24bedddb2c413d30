# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A ball in two blocks that touch in the view's middle, one to the left and one to the right, and the filter, not
applied, to pick on them."""

from paraview.simple import *

ball = Sphere(registrationName="Ball", ThetaResolution=32, PhiResolution=32)
sides = PointDatatoCellData(Input=Calculator(Input=ball, ResultArrayName="side", Function="coordsX"))
halves = GroupDatasets(
    registrationName="Halves",
    Input=[Threshold(Input=sides, Scalars=["CELLS", "side"], LowerThreshold=low, UpperThreshold=high)
           for low, high in ((-1, 0), (1e-9, 1))],
    BlockNames=["left", "right"])
view = GetActiveViewOrCreate("RenderView")
Show(halves, view).SetRepresentationType("Surface")
view.CameraPosition = [0, 0, 4]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20
SetActiveSource(GeodesicDistance(registrationName="Distance", Input=halves))
Render()
