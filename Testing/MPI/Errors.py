"""An error on one rank is one on all, with one message and without a deadlock, and the next run is right.

usage: mpiexec -n N pvbatch --sym Errors.py OUR_PLUGIN        (N > 1)
"""

import os
import sys

from paraview import simple

sys.path.append(os.path.dirname(__file__))
import harness
import pieces

harness.load(sys.argv[1])
SEED = [1.4, 0, 0]


def expect(words, source, **options):
    distance = simple.GeodesicDistance(Input=source, **options)
    messages = harness.messages_of(distance.UpdatePipeline)
    for word in (words, ) if isinstance(words, str) else words:
        assert word in messages, (harness.RANKS, word, messages)
    assert distance.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints() == 0
    simple.Delete(distance)
    pieces.controller().Barrier()


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
expect("no point array", harness.surface("torus", "slabs", False, harness.RANKS - 1), SeedPositions=SEED,
       CostArray=["POINTS", "Cost"])
expect("barrier", torus, SeedPositions=[0, 1, 0.4], BarrierArray=["POINTS", "PointNumber"])
expect("Generate Global Ids", torus, SeedPointIds=[7])
expect("Generate Global Ids", torus, SeedPositions=SEED, MergeCoincidentPoints=0)
expect("Seed point id 11 ", with_ids, SeedPointIds=[10, 11])
expect("Destination point id 12 ", with_ids, SeedPointIds=[10], DestinationPointIds=[12])
expect("multiple of 3", torus, SeedPositions=[1, 2])
expect("maximum distance", torus, SeedPositions=SEED, UseMaximumDistance=1, MaximumDistance=-1)
expect("lines", torus, SeedSource=simple.PolyLineSource(Points=[1, 0, 0, 0, 1, 0]))
expect("lines", torus, SeedPositions=SEED, BarrierSource=simple.PolyLineSource(Points=[1, 0, 0, 0, 1, 0]))
expect("no surface", simple.PointSource(), SeedPositions=SEED)

expect_success(torus, SeedPositions=SEED)
expect_success(with_ids, SeedPointIds=[10], MergeCoincidentPoints=0)
# The source is on one rank, or on all alike.
expect_success(torus, SeedSource=simple.PointSource(Center=SEED, NumberOfPoints=5, Radius=0.1))

path = simple.GeodesicPath(Input=torus, WaypointPositions=[1.4, 0, 0, -1.4, 0, 0])
assert "spread over" in harness.messages_of(path.UpdatePipeline)

# Aborted on one rank, no rank has an output; all know.
distance = simple.GeodesicDistance(Input=torus, SeedPositions=SEED)
algorithm = distance.GetClientSideObject()
if harness.IS_FIRST:
    algorithm.AddObserver("ProgressEvent", lambda *_: algorithm.AbortExecuteOn())
distance.UpdatePipeline()
assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
