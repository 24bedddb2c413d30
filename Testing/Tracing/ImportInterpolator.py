# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The interpolator is used from Python, without ParaView's Python and without a display."""

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkInteractionWidgets import (
    vtkOrientedGlyphContourRepresentation,
    vtkPolyDataContourLineInterpolator,
    vtkPolygonalSurfacePointPlacer,
)
from vtkmodules.vtkRenderingCore import vtkRenderer
import vtkmodules.vtkRenderingOpenGL2

from surfacegeodesics import vtkPolygonalSurfaceContourLineInterpolator2

sphere = vtkSphereSource()
sphere.SetThetaResolution(32)
sphere.SetPhiResolution(33)
sphere.Update()
surface = sphere.GetOutput()

interpolator = vtkPolygonalSurfaceContourLineInterpolator2()
assert isinstance(interpolator, vtkPolyDataContourLineInterpolator)
assert interpolator.IsA("vtkPolygonalSurfaceContourLineInterpolator2")
assert interpolator.GetGeodesicMethod() == interpolator.DijkstraMethod == 0
interpolator.SetGeodesicMethodToFastMarching()
assert interpolator.GetGeodesicMethod() == interpolator.FastMarchingMethod == 1
interpolator.SetDistanceOffset(0.0)
interpolator.GetPolys().AddItem(surface)

placer = vtkPolygonalSurfacePointPlacer()
placer.GetPolys().AddItem(surface)
renderer = vtkRenderer()
renderer.GetActiveCamera()  # Makes one.
contour = vtkOrientedGlyphContourRepresentation()
contour.SetRenderer(renderer)
contour.SetPointPlacer(placer)
contour.SetLineInterpolator(interpolator)
# Along a meridian from pole to equator: the points of it are on the way.
equator = 2 + 31 // 2
for node in (0, equator):
    position = surface.GetPoint(node)
    placer.UpdateNodeWorldPosition(position, node)
    contour.AddNodeAtWorldPosition(position)
ids = vtkIdList()
interpolator.GetContourPointIds(contour, ids)
along = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
assert along == [0, 0] + list(range(2, equator + 1)) + [equator], along
