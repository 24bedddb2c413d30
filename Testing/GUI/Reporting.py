# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ball.py, and every change of the points in the panel is written to the file that REPORT names."""

import json
import os

from paraview.simple import *

exec(open(os.path.join(os.environ["PYTHONPATH"], "Ball.py"), encoding="utf-8").read())
SEEDS = GetActiveSource().SMProxy.GetProperty("SeedPositions")


def report(*_):
    values = [SEEDS.GetUncheckedElement(i) for i in range(SEEDS.GetNumberOfUncheckedElements())]
    part = os.environ["REPORT"] + ".part"
    with open(part, "w", encoding="utf-8") as file:
        json.dump(values, file)
    os.replace(part, os.environ["REPORT"])


SEEDS.AddObserver("UncheckedPropertyModifiedEvent", report)
report()
