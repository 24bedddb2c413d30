# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Our plugin, ParaView's plugin GeodesicMeasurement and our Python package work in one process, in
whatever order they come into it.

usage: Coexistence.py OUR_PLUGIN THEIR_PLUGIN STEP..., the steps being plugin, bundled and package
"""

import math
import sys

from paraview import servermanager, simple

RADIUS = 0.5
NORTH, SOUTH = (0, 0, RADIUS), (0, 0, -RADIUS)

# Half a great circle. First-order schemes are within 2 % of it on this mesh, in either direction.
POLE_TO_POLE = math.pi * RADIUS
TOLERANCE = 0.02 * POLE_TO_POLE


def sphere():
    return simple.Sphere(Radius=RADIUS, ThetaResolution=64, PhiResolution=64)


def assert_pole_to_pole(length):
    assert abs(length - POLE_TO_POLE) < TOLERANCE, f"{length} instead of {POLE_TO_POLE}"


def read_everything(proxy):
    """Reads all properties of a proxy, and calls each getter of its client-side object."""
    for name in proxy.ListProperties():
        proxy.GetPropertyValue(name)
    algorithm = proxy.GetClientSideObject()
    for name in dir(algorithm):
        if name.startswith("Get"):
            try:
                getattr(algorithm, name)()
            except TypeError:
                pass  # A getter that needs arguments
    str(algorithm)
    return algorithm


def check_plugin():
    distance = simple.GeodesicDistance(Input=sphere(), SeedPositions=NORTH)
    distance.UpdatePipeline()
    low, high = distance.PointData["GeodesicDistance"].GetRange()
    assert low == 0
    assert_pole_to_pole(high)
    return distance


def check_bundled():
    seed = simple.Calculator(
        Input=sphere(), ResultArrayName="Seed", Function=f"coordsZ > {0.9999 * RADIUS}")
    distance = simple.FastMarchingGeodesicDistanceFieldFromBinaryField(Input=seed)
    distance.SeedsNonZeroField = ["POINTS", "Seed"]
    distance.UpdatePipeline()
    assert_pole_to_pole(distance.PointData["DistanceField"].GetRange()[1])
    assert read_everything(distance).GetClassName() == "vtkFastMarchingGeodesicDistance"

    poles = simple.PolyLineSource(Points=[*NORTH, *SOUTH])
    path = simple.GeodesicMeasurement(Input=sphere(), Endpoints=poles)
    path.UpdatePipeline()
    assert_pole_to_pole(path.FieldData["TotalLength"].GetRange()[0])
    assert read_everything(path).GetClassName() == "vtkGeodesicsBetweenPoints"
    return distance


def check_package():
    from surfacegeodesics import vtkFastMarchingGeodesicDistance, vtkFastMarchingGeodesicPath
    from vtkmodules.vtkCommonCore import vtkIdList

    mesh = servermanager.Fetch(sphere())
    seeds = vtkIdList()
    seeds.InsertNextId(mesh.FindPoint(NORTH))
    distance = vtkFastMarchingGeodesicDistance()
    distance.SetInputData(mesh)
    distance.SetSeeds(seeds)
    distance.SetFieldDataName("Distance")
    distance.Update()
    assert_pole_to_pole(distance.GetMaximumDistance())
    assert distance.GetOutput().GetPointData().HasArray("Distance")
    assert type(distance.NewInstance()) is vtkFastMarchingGeodesicDistance

    path = vtkFastMarchingGeodesicPath()
    path.SetInputData(mesh)
    path.SetBeginPointId(mesh.FindPoint(SOUTH))
    path.SetSeeds(seeds)
    path.Update()
    assert_pole_to_pole(path.GetGeodesicLength())
    assert type(path.NewInstance()) is vtkFastMarchingGeodesicPath
    assert type(path.GetGeodesic()) is vtkFastMarchingGeodesicDistance
    str(path)


def check_apart(ours, theirs):
    """Python takes each object for what it is."""
    import surfacegeodesics

    assert type(read_everything(ours)) is surfacegeodesics.vtkSurfaceGeodesicDistance
    assert not isinstance(
        theirs.GetClientSideObject(), surfacegeodesics.vtkPolyDataGeodesicDistance)


def main(our_plugin, their_plugin, *steps):
    plugins = {"plugin": our_plugin, "bundled": their_plugin}
    checks = {"plugin": check_plugin, "bundled": check_bundled, "package": check_package}
    assert sorted(steps) == sorted(checks)

    for step in steps:
        if step in plugins:
            simple.LoadPlugin(plugins[step], remote=False, ns=vars(simple))
        checks[step]()
    check_apart(ours=check_plugin(), theirs=check_bundled())
    check_package()


main(*sys.argv[1:])
