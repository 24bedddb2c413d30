# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A state file and a Python trace give back every property and the same field.

usage: StateAndTrace.py OUR_PLUGIN
"""

import os
import sys
import tempfile

import numpy as np
from paraview import simple, smtrace

import testing

# Properties of arrays, inputs and lists are among them: none has its default.
SETTINGS = {
    "SeedPositions": [0.1, 0.2, 0.45, -0.3, 0.2, -0.3],
    "SeedPointIds": [7, 12],
    "SeedSource": "Seeds",
    "SeedArray": ["POINTS", "north"],
    "SeedSelection": "Chosen",
    "Method": "Dijkstra",
    "Tolerance": 0.01,
    "MemoryLimit": 2.5,
    "NumberOfThreads": 3,
    "UseMaximumDistance": 1,
    "MaximumDistance": 0.375,
    "DestinationPositions": [0.5, 0.0, 0.0],
    "DestinationPointIds": [1, 20],
    "DestinationMode": "All",
    "CostArray": ["POINTS", "cost"],
    "CostMode": "Speed",
    "BarrierArray": ["POINTS", "south"],
    "BarrierSource": "Wall",
    "DistanceArrayName": "far",
    "ComputeNearestSeed": 1,
    "UnreachedAs": "Value",
    "UnreachedValue": -5.5,
    "MergeCoincidentPoints": 0,
    "ConnectBlocks": 0,
    "SpreadWork": 1,
    "GatherForExact": 1,
}
INPUTS = ("SeedSource", "SeedSelection", "BarrierSource")

testing.load(sys.argv[1])


def make_sources():
    """The sources by their names; the last one is the surface."""
    simple.PolyLineSource(registrationName="Seeds", Points=[0.5, 0, 0, 0.5, 0, 0])
    simple.PolyLineSource(registrationName="Wall", Points=[-0.5, 0, 0, -0.5, 0, 0])
    simple.IDSelectionSource(registrationName="Chosen", FieldType="POINT", IDs=[0, 15])
    surface = simple.Sphere(registrationName="Ball")
    for name, function in (
            ("north", "coordsZ > 0.49"), ("south", "coordsZ < -0.49"), ("cost", "1.5 + coordsX")):
        surface = simple.Calculator(
            registrationName=f"With {name}", Input=surface, ResultArrayName=name, Function=function)
    return surface


def values():
    return {
        name: simple.FindSource(value) if name in INPUTS else value
        for name, value in SETTINGS.items()}


def value_of(proxy, name):
    """A property's value, as a list where the settings have a list."""
    value = proxy.GetPropertyValue(name)
    return list(value) if isinstance(SETTINGS[name], list) else value


def expect_settings(distance, fields):
    for name, value in SETTINGS.items():
        found = value_of(distance, name)
        assert found == (simple.FindSource(value) if name in INPUTS else value), (name, found)
    for name, field in fields.items():
        np.testing.assert_array_equal(testing.array_of(distance, name), field)


# Each property is named, and differs from its default.
surface = make_sources()
plain = simple.GeodesicDistance(Input=surface)
others = {"Input", "MaximumDistanceReached", "NumberOfVisitedPoints", "NumberOfRounds", "NumberOfUpdates",
          "LongestChainOfUpdates", "BytesExchanged", "MostPointsOnARank", "ErrorText", "RunTime",
          "ThinTriangles", "NoticeText",
          # Point seeds have no sides; see SignedDistance.py.
          "Signed"}
assert set(plain.ListProperties()) == {*SETTINGS, *others}, plain.ListProperties()
for name, value in values().items():
    assert value_of(plain, name) != value, name
simple.Delete(plain)

distance = simple.GeodesicDistance(registrationName="Distance", Input=surface, **values())
fields = {name: testing.array_of(distance, name).copy() for name in ("far", "NearestSeed")}
assert (fields["far"] == -5.5).any() and (fields["far"] > 0).any()

with tempfile.TemporaryDirectory() as folder:
    state = os.path.join(folder, "distance.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))
    simple.LoadState(state)
expect_settings(simple.FindSource("Distance"), fields)

# The trace of making and changing the filter, replayed in an empty session.
simple.ResetSession()
simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))
smtrace.start_trace()
traced = simple.GeodesicDistance(registrationName="Distance", Input=make_sources())
change = smtrace.PropertiesModified(traced)
for name, value in values().items():
    traced.SetPropertyWithName(name, value)
change.finalize()
trace = smtrace.stop_trace()
for name in SETTINGS:
    assert f".{name} = " in trace or f"    {name}=" in trace, (name, trace)
simple.ResetSession()
simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))
exec(trace, {})
expect_settings(simple.FindSource("Distance"), fields)
