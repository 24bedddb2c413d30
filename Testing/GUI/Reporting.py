# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The script of this folder that SETUP names, on a green background, by which the view is found on the screen; and every
change of the points in the panel is written to the file that REPORT names."""

import json
import os

from paraview.simple import *

exec(open(os.path.join(os.environ["PYTHONPATH"], os.environ["SETUP"]), encoding="utf-8").read())
view.UseColorPaletteForBackground = 0
view.BackgroundColorMode = "Single Color"
view.Background = [0, 1, 0]
Render()
FILTER = GetActiveSource().SMProxy
POINTS = FILTER.GetProperty("SeedPositions") or FILTER.GetProperty("WaypointPositions")


def report(*_):
    values = [POINTS.GetUncheckedElement(i) for i in range(POINTS.GetNumberOfUncheckedElements())]
    part = os.environ["REPORT"] + ".part"
    with open(part, "w", encoding="utf-8") as file:
        json.dump(values, file)
    os.replace(part, os.environ["REPORT"])


POINTS.AddObserver("UncheckedPropertyModifiedEvent", report)
report()
