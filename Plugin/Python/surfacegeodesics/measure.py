# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances and paths along surfaces by one call each, on plain VTK and numpy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Union

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from .vtkFiltersSurfaceGeodesics import vtkSurfaceGeodesicDistance, vtkSurfaceGeodesicPath

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Method = Literal["FastMarching", "Dijkstra", "Exact", "VirtualSources", "Bounded"]
_METHODS = ("FastMarching", "Dijkstra", "Exact", "VirtualSources", "Bounded")


def distance(
    surface: vtkPolyData,
    seeds: ArrayLike,
    *,
    method: Method = "FastMarching",
    cost: Union[str, None] = None,
    maximum: Union[float, None] = None,
) -> np.ndarray:
    """The distance of each point of a surface to the nearest seed, along the surface.

    surface: triangles, polygons or strips; PyVista's PolyData is a vtkPolyData.
    seeds: positions as an array of n x 3 real numbers, each moved to the nearest point of the surface; or point ids
        as a list of integers.
    method: see the guide's page "Choose a method".
    cost: the name of a point array with the cost of a unit of length, positive everywhere.
    maximum: distances end here.

    Returns one number for each point, in the unit of length of the surface; NaN where there is no distance.
    Raises ValueError if something is wrong with the arguments; the message says what helps.
    """
    solver = vtkSurfaceGeodesicDistance()
    _prepare(solver, surface, method, cost)
    given = np.asarray(seeds)
    if given.ndim == 1 and np.issubdtype(given.dtype, np.integer):
        for point in given:
            solver.AddSeedPointId(int(point))
    else:
        for coordinate in _positions(given, "seeds"):
            solver.AddSeedCoordinate(coordinate)
    if maximum is not None:
        solver.SetUseMaximumDistance(True)
        solver.SetMaximumDistance(maximum)
    output = _run(solver)
    return vtk_to_numpy(output.GetPointData().GetArray(solver.GetDistanceArrayName())).copy()


def path(
    surface: vtkPolyData,
    points: ArrayLike,
    *,
    closed: bool = False,
    method: Method = "FastMarching",
    cost: Union[str, None] = None,
) -> tuple[vtkPolyData, float]:
    """The shortest path along a surface through points, and its length.

    surface: triangles, polygons or strips; PyVista's PolyData is a vtkPolyData.
    points: positions as an array of n x 3 real numbers, in order, each moved to the nearest point of the surface.
    closed: the path leads back to the first point.
    method, cost: as of distance().

    Returns one polyline for each segment, with the point array ArcLength and the cell array Length, and the sum of
    the lengths in the unit of length of the surface.
    Raises ValueError if something is wrong with the arguments, or if no path joins two of the points.
    """
    solver = vtkSurfaceGeodesicPath()
    _prepare(solver, surface, method, cost)
    for coordinate in _positions(np.asarray(points), "points"):
        solver.AddWaypointCoordinate(coordinate)
    solver.SetClosed(closed)
    output = _run(solver)
    return output, solver.GetTotalLength()


def _prepare(solver, surface: vtkPolyData, method: str, cost: Union[str, None]) -> None:
    if method not in _METHODS:
        raise ValueError(f"There is no method {method!r}; the methods are {', '.join(_METHODS)}.")
    solver.SetInputDataObject(surface)
    solver.SetMethod(_METHODS.index(method))
    if cost is not None:
        solver.SetInputArrayToProcess(solver.COST_ARRAY, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, cost)


def _positions(given: np.ndarray, name: str) -> list[float]:
    """x, y and z of one point after the other."""
    positions = np.atleast_2d(np.asarray(given, dtype=float))
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise ValueError(f"The shape of {name} is {given.shape}; give n x 3 real numbers.")
    return positions.ravel().tolist()


def _run(solver) -> vtkPolyData:
    # With an observer, VTK tells it of errors instead of printing them.
    solver.AddObserver("ErrorEvent", lambda *_: None)
    solver.Update()
    if solver.GetErrorText():
        raise ValueError(solver.GetErrorText())
    return solver.GetOutputDataObject(0)
