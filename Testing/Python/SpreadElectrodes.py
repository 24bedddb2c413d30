# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the example SpreadElectrodes.py and checks the file that it writes.

usage: SpreadElectrodes.py OUR_PLUGIN EXAMPLE
"""

import csv
import os
import runpy
import sys
import tempfile

import numpy as np

plugin, example = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder:
    sys.argv = [example, plugin, folder]
    runpy.run_path(example, run_name="__main__")
    with open(os.path.join(folder, "Electrodes.csv"), encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
assert len(rows) == 64
places = np.array([[float(row[f"Points:{i}"]) for i in range(3)] for row in rows])
distances = np.array([float(row["GeodesicDistance"]) for row in rows])
assert np.abs(places[:3] - [[0, 0, 90], [75, 0, 0], [-75, 0, 0]]).max() < 1
assert (distances[:3] == -1).all() and (np.diff(distances[3:]) <= 1e-6).all()
assert (places[:, 2] > -12).all()
# A straight line is at most as long as one along the surface, and on this one not much shorter for near points.
apart = np.linalg.norm(places[:, None] - places[None], axis=2) + 1e9 * np.eye(64)
assert apart.min() > 0.9 * distances[-1] > 10, (apart.min(), distances[-1])
