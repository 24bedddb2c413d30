# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""An error on one rank is one on all, with one message and without a deadlock, and the next run is right.

usage: mpiexec -n N pvbatch --sym Errors.py OUR_PLUGIN        (N > 1)
"""

import math
import os
import sys

from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkDataObject

sys.path.append(os.path.dirname(__file__))
import harness
import pieces

harness.load(sys.argv[1])
SEED = [1.4, 0, 0]
POINTS, TABLE_ROWS = vtkDataObject.POINT, vtkDataObject.ROW


def expect(words, source, make=simple.GeodesicDistance, **options):
    proxy = make(Input=source, **options)
    messages = harness.messages_of(proxy.UpdatePipeline)
    for word in (words, ) if isinstance(words, str) else words:
        assert word in messages, (harness.RANKS, word, messages)
    assert proxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfElements(
        TABLE_ROWS if make is simple.GeodesicDistanceMatrix else POINTS) == 0
    simple.Delete(proxy)
    pieces.controller().Barrier()


def expect_no_path(words, source, **options):
    expect(words, source, simple.GeodesicPath, **options)


def expect_success(source, **options):
    distance = simple.GeodesicDistance(Input=source, **options)
    messages = harness.messages_of(distance.UpdatePipeline)
    assert messages == "", messages
    assert harness.informed(distance, "NumberOfVisitedPoints") == 7200
    simple.Delete(distance)


torus = harness.surface("torus", "slabs")
with_ids = harness.surface("torus", "slabs", True)
expect("no seed", torus)
# One point, which is on one rank only; a piece's point ids say nothing without the rank, global ids do.
expect(("BadCost", "-1", "on rank"), torus, SeedPositions=SEED, CostArray=["POINTS", "BadCost"])
expect(("BadCost", "-1", "point 10810"), with_ids, SeedPositions=SEED, CostArray=["POINTS", "BadCost"])
expect("not a point array", harness.surface("torus", "slabs", False, harness.RANKS - 1), SeedPositions=SEED,
       CostArray=["POINTS", "Cost"])
expect("barrier", torus, SeedPositions=[0, 1, 0.4], BarrierArray=["POINTS", "PointNumber"])
expect(harness.GLOBAL_IDS_FILTER, torus, SeedPointIds=[7])
expect(harness.GLOBAL_IDS_FILTER, torus, SeedPositions=SEED, MergeCoincidentPoints=0)
expect("but on several ranks ids must be 0 or more", harness.surface("torus", "slabs", -10), SeedPositions=SEED)
expect("Seed point id 11 ", with_ids, SeedPointIds=[10, 11])
expect("Destination point id 12 ", with_ids, SeedPointIds=[10], DestinationPointIds=[12])
expect("multiple of 3", torus, SeedPositions=[1, 2])
expect("maximum distance", torus, SeedPositions=SEED, UseMaximumDistance=1, MaximumDistance=-1)
LINE = simple.PolyLineSource(Points=[0.3, 0.2, 0, 0.3, 0.2, 5])
expect("SeedSource's line 0 can't be joined from its point 0 to its point 1", harness.surface("parts", "random"),
       SeedSource=LINE)
expect("BarrierSource's line 0 can't be joined", harness.surface("parts", "slabs"), SeedPositions=SEED,
       BarrierSource=LINE)
expect("Seed 0 lies on a line of BarrierSource", torus, SeedPositions=SEED,
       BarrierSource=simple.PolyLineSource(Points=SEED + [0, 1, 0]))
# Cells of CellWall, on one rank or two.
expect("barrier", torus, SeedSource=simple.PolyLineSource(Points=[0.02, 1.2, 0.34, -0.02, 1.3, 0.26]),
       BarrierArray=["CELLS", "CellWall"])
expect("SpreadWork can't be used with BarrierSource", torus, SeedPositions=SEED, SpreadWork=1,
       BarrierSource=simple.PolyLineSource(Points=[0.5, 1.2, 0.2, 0.2, 1.2, 0.3]))
expect(("Exact", "several ranks", "GatherForExact"), torus, SeedPositions=SEED, Method="Exact")
expect("costs", torus, SeedPositions=SEED, Method="Exact", GatherForExact=1, CostArray=["POINTS", "Cost"])
expect(("SeedSource's line 0", "open"), torus, Signed=1, SeedSource=simple.PolyLineSource(Points=SEED + [0.02, 1.2, 0.34]))
expect("seed 0 is not a line", torus, Signed=1, SeedPositions=SEED)
expect("Geodesic Isolines needs all of it on one", simple.GeodesicDistance(Input=torus, SeedPositions=SEED),
       simple.GeodesicIsolines)
expect("no surface", simple.PointSource(), SeedPositions=SEED)

# Each rank runs the script, and may set something else.
expect("same on all ranks", torus, SeedPositions=SEED if harness.IS_FIRST else SEED + SEED)
expect("same on all ranks", torus, SeedPositions=SEED if harness.IS_FIRST else [])
expect("same on all ranks", torus, SeedPositions=SEED, Signed=int(harness.IS_FIRST))
expect("same on all ranks", torus, SeedPositions=SEED, MergeCoincidentPoints=int(harness.IS_FIRST))
expect("same on all ranks", torus, SeedPositions=SEED, CostArray=["POINTS", "Cost" if harness.IS_FIRST else "None"])
expect("same on all ranks", torus, SeedPositions=SEED, Method="Dijkstra" if harness.IS_FIRST else "FastMarching")



def other_value(sm_property, value):
    """A value that a property does not have, of those that its domains allow."""
    if sm_property.GetClassName() == "vtkSMStringVectorProperty":
        return ["POINTS", "Cost"] if sm_property.GetNumberOfElements() > 1 else "other"
    names = sm_property.FindDomain("vtkSMEnumerationDomain")
    if names:
        texts = [names.GetEntryText(i) for i in range(names.GetNumberOfEntries())]
        return texts[1] if sm_property.GetElement(0) == names.GetEntryValue(0) else texts[0]
    if sm_property.GetRepeatable():
        return [1, 2, 3] if len(value) == 0 else []
    return value - 1 if value >= 1 else value + 1


def expect_all_properties_compared(make, source, **options):
    """Whatever property of a filter differs between ranks: all ranks say so."""
    tried = []
    for name in make(Input=source).ListProperties():
        proxy = make(Input=source, **options)
        sm_property = proxy.GetProperty(name).SMProperty
        if not sm_property.IsA("vtkSMInputProperty") and not sm_property.GetInformationOnly():
            if not harness.IS_FIRST and sm_property.GetIsInternal():
                sm_property.SetElement(0, 1)
                proxy.SMProxy.UpdateVTKObjects()
            elif not harness.IS_FIRST:
                setattr(proxy, name, other_value(sm_property, proxy.GetPropertyValue(name)))
            messages = harness.messages_of(proxy.UpdatePipeline)
            assert "same on all ranks" in messages, (make.__name__, name, messages)
            tried.append(name)
        simple.Delete(proxy)
    return tried


compared = expect_all_properties_compared(simple.GeodesicDistance, torus, SeedPositions=SEED)
assert {"SeedPositions", "SeedPointIds", "CostArray", "Method", "DistanceArrayName"} <= set(compared), compared
compared = expect_all_properties_compared(simple.GeodesicPath, torus, WaypointPositions=[1.3, 0.2, 0.3, -1.35, 0.1, 0.1])
assert {"WaypointPositions", "StartPositions", "MaximumPathLength", "HeightOffset"} <= set(compared), compared
compared = expect_all_properties_compared(simple.GeodesicRegion, torus, InsidePositions=SEED)
assert {"InsidePositions", "Extract", "RegionArrayName", "ConnectBlocks"} <= set(compared), compared

# Points are no lines.
messages = harness.messages_of(simple.GeodesicRegion(Input=torus, Lines=simple.PointSource()).UpdatePipeline)
assert "1 points but no line" in messages, messages

compared = expect_all_properties_compared(simple.GeodesicSamples, torus)
assert {"NumberOfSamples", "Spacing", "FirstPositions", "Method"} <= set(compared), compared
compared = expect_all_properties_compared(simple.GeodesicCentre, torus)
assert {"RelativeError", "MaximumNumberOfFields", "Method"} <= set(compared), compared
messages = harness.messages_of(simple.GeodesicCentre(Input=torus).UpdatePipeline)
assert f"spread over {harness.RANKS} ranks" in messages and "Aggregate Dataset" in messages, messages
compared = expect_all_properties_compared(simple.GeodesicDistanceMatrix, torus, LandmarkPositions=SEED)
assert {"LandmarkPositions", "SecondLandmarkPositions", "Method", "MemoryLimit"} <= set(compared), compared

expect_success(torus, SeedPositions=SEED)
expect_success(with_ids, SeedPointIds=[10], MergeCoincidentPoints=0)
# Ids that neither an int nor a double holds.
LARGE = 2**60 + 1
with_large_ids = harness.surface("torus", "slabs", LARGE)
expect_success(with_large_ids, SeedPointIds=[LARGE])
expect(f"Destination point id {LARGE + 1} ", with_large_ids, SeedPointIds=[LARGE], DestinationPointIds=[LARGE + 1])
expect("same on all ranks", with_large_ids, SeedPointIds=[LARGE + 3 * harness.IS_FIRST])
# The source is on one rank, or on all alike.
expect_success(torus, SeedSource=simple.PointSource(Center=SEED, NumberOfPoints=5, Radius=0.1))

ENDS = [1.3, 0.2, 0.3, -1.35, 0.1, 0.1]
expect_no_path("the number of waypoints is 1", torus, WaypointPositions=ENDS[:3])
expect_no_path("multiple of 3", torus, WaypointPositions=ENDS[:5])
expect_no_path(("BadCost", "-1"), torus, WaypointPositions=ENDS, CostArray=["POINTS", "BadCost"])
expect_no_path("not a point array", harness.surface("torus", "slabs", False, harness.RANKS - 1), WaypointPositions=ENDS,
               CostArray=["POINTS", "Cost"])
expect_no_path(("Waypoint 1 is at point ", "on a barrier"), torus, WaypointPositions=ENDS,
               BarrierArray=["POINTS", "PointNumber"])
expect_no_path("Waypoint 1 lies on a line of BarrierSource", torus, WaypointPositions=ENDS,
               BarrierSource=simple.PolyLineSource(Points=ENDS[3:] + [-0.3, 1, 0.3]))
expect_no_path("BarrierSource's line 0 can't be joined", harness.surface("parts", "slabs"), WaypointPositions=ENDS,
               BarrierSource=LINE)
expect_no_path(harness.GLOBAL_IDS_FILTER, torus, WaypointPositions=ENDS, MergeCoincidentPoints=0)
expect_no_path("no surface", simple.PointSource(), WaypointPositions=ENDS)
expect_no_path("same on all ranks", torus, WaypointPositions=ENDS[:3] + [-1.3, harness.IS_FIRST, 0])
for option in (dict(MaximumPathLength=-1), dict(UseMaximumPathLength=1), dict(HeightOffset=0.1)):
    expect_no_path("same on all ranks", torus, WaypointPositions=ENDS, **(option if harness.IS_FIRST else {}))
expect_no_path("MaximumPathLength is -1", torus, WaypointPositions=ENDS, UseMaximumPathLength=1, MaximumPathLength=-1)


def expect_no_matrix(words, source, **options):
    expect(words, source, simple.GeodesicDistanceMatrix, **options)


expect_no_matrix("There is no landmark", torus)
expect_no_matrix("multiple of 3", torus, LandmarkPositions=ENDS[:5])
expect_no_matrix("multiple of 3", torus, LandmarkPositions=ENDS, SecondLandmarkPositions=ENDS[:5])
expect_no_matrix(("Exact", "a surface on several ranks"), torus, LandmarkPositions=ENDS, Method="Exact")
expect_no_matrix("Landmark 1 is at point ", torus, LandmarkPositions=ENDS, BarrierArray=["POINTS", "PointNumber"])
expect_no_matrix("no surface", simple.PointSource(), LandmarkPositions=ENDS)

path = simple.GeodesicPath(Input=torus, WaypointPositions=ENDS)
assert harness.messages_of(path.UpdatePipeline) == ""
# The same as where one rank has all of the surface.
whole = simple.GeodesicPath(Input=harness.surface("torus", "first"), WaypointPositions=ENDS)
whole.UpdatePipeline()
LENGTH = harness.informed(whole, "TotalLength")
assert LENGTH >= math.dist(ENDS[:3], ENDS[3:]), LENGTH
assert abs(harness.informed(path, "TotalLength") - LENGTH) <= 1e-9 * LENGTH, (LENGTH, harness.informed(path, "TotalLength"))


def result_of(proxy):
    """What a filter measured, and the number of its points on this rank."""
    name = "TotalLength" if proxy.GetXMLName() == "GeodesicPath" else "MaximumDistanceReached"
    return harness.informed(proxy, name), proxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints()


# Aborted on one rank, no rank has an output; all know.
for proxy in (simple.GeodesicDistance(Input=torus, SeedPositions=SEED),
              simple.GeodesicPath(Input=torus, WaypointPositions=ENDS)):
    algorithm = proxy.GetClientSideObject()
    if harness.IS_FIRST:
        observer = algorithm.AddObserver("ProgressEvent", lambda *_, filter=algorithm: filter.AbortExecuteOn())
    assert harness.messages_of(proxy.UpdatePipeline) == ""
    assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
    # Nothing of the run that was aborted is taken for a result by the next one, whatever changes.
    if harness.IS_FIRST:
        algorithm.RemoveObserver(observer)
        algorithm.AbortExecuteOff()
    if proxy.GetXMLName() == "GeodesicPath":
        proxy.HeightOffset = 0.01
    else:
        proxy.DestinationPositions = ENDS[3:]
    assert harness.messages_of(proxy.UpdatePipeline) == ""
    fresh = getattr(simple, proxy.GetXMLName())(Input=torus)
    for name in ("SeedPositions", "DestinationPositions", "WaypointPositions", "HeightOffset"):
        if proxy.GetProperty(name):
            setattr(fresh, name, proxy.GetPropertyValue(name))
    fresh.UpdatePipeline()
    value, points = result_of(fresh)
    assert value > 0 and abs(result_of(proxy)[0] - value) <= 1e-9 * value and result_of(proxy)[1] == points, (
        proxy.GetXMLName(), result_of(proxy), value, points)
