# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A square that is lifted as time goes by, seen from above, and the filter on it."""

from paraview.simple import *

lift = ProgrammableSource(registrationName="Lift", OutputDataSetType="vtkPolyData")
lift.ScriptRequestInformation = """
information = self.GetOutputInformation(0)
information.Set(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS(), [0.0, 1.0], 2)
information.Set(vtk.vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [0.0, 1.0], 2)
"""
lift.Script = """
from vtkmodules.vtkFiltersSources import vtkPlaneSource
now = self.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
plane = vtkPlaneSource()
plane.SetResolution(8, 8)
plane.Push(0.25 * (now or 0.0))
plane.Update()
output.ShallowCopy(plane.GetOutput())
"""
lift.UpdatePipelineInformation()
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
view = GetActiveViewOrCreate("RenderView")
Show(lift, view)
view.CameraPosition = [0, 0, 4]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 20
SetActiveSource(GeodesicDistance(registrationName="Distance", Input=lift))
Render()
