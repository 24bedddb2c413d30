"""A state file and a Python trace give back every property and the same field.

usage: StateAndTrace.py OUR_PLUGIN
"""

import os
import sys
import tempfile

import numpy as np
from paraview import simple, smtrace

import testing

SETTINGS = {
    "SeedPositions": [0.1, 0.2, 0.45, -0.3, 0.2, -0.3],
    "Method": "Dijkstra",
    "UseMaximumDistance": 1,
    "MaximumDistance": 0.375,
    "DistanceArrayName": "far",
    "UnreachedAs": "Value",
    "UnreachedValue": -5.5,
    "MergeCoincidentPoints": 0,
}

testing.load(sys.argv[1])


def expect_settings(distance, field):
    for name, value in SETTINGS.items():
        found = distance.GetPropertyValue(name)
        found = list(found) if name == "SeedPositions" else found
        assert found == value, (name, found, value)
    np.testing.assert_array_equal(testing.array_of(distance, "far"), field)


def make():
    return simple.GeodesicDistance(
        registrationName="Distance", Input=simple.Sphere(registrationName="Ball"), **SETTINGS)


field = testing.array_of(make(), "far")
assert (field == -5.5).any() and (field >= 0).any()

with tempfile.TemporaryDirectory() as folder:
    state = os.path.join(folder, "distance.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))
    simple.LoadState(state)
expect_settings(simple.FindSource("Distance"), field)

# The trace of making and changing the filter, replayed in an empty session.
simple.ResetSession()
simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))
smtrace.start_trace()
traced = simple.GeodesicDistance(
    registrationName="Distance", Input=simple.Sphere(registrationName="Ball"))
change = smtrace.PropertiesModified(traced)
for name, value in SETTINGS.items():
    traced.SetPropertyWithName(name, value)
change.finalize()
trace = smtrace.stop_trace()
assert "SeedPositions = [0.1, 0.2, 0.45, -0.3, 0.2, -0.3]" in trace, trace
simple.ResetSession()
simple.LoadPlugin(sys.argv[1], remote=False, ns=vars(simple))
exec(trace, {})
expect_settings(simple.FindSource("Distance"), field)
