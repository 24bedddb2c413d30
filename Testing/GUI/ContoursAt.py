# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A box of voxels seen from z and, not applied, a filter of another plugin with the same panel widget."""

import os

from paraview.simple import *

LoadPlugin(os.path.join(os.environ["PYTHONPATH"], "ContoursAt.xml"), remote=False, ns=globals())
voxels = Wavelet(registrationName="Voxels", WholeExtent=[-5, 5, -5, 5, -5, 5])
view = GetActiveViewOrCreate("RenderView")
Show(voxels, view).SetRepresentationType("Surface")
view.CameraPosition = [0, 0, 60]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20
SetActiveSource(ContoursAt(registrationName="Contours", Input=voxels))
Render()
