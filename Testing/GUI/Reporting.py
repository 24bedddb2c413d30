# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ball.py on a green background, by which the view is found on the screen; and every change of the points in the panel is
written to the file that REPORT names."""

import json
import os

from paraview.simple import *

exec(open(os.path.join(os.environ["PYTHONPATH"], "Ball.py"), encoding="utf-8").read())
view.UseColorPaletteForBackground = 0
view.BackgroundColorMode = "Single Color"
view.Background = [0, 1, 0]
Render()
SEEDS = GetActiveSource().SMProxy.GetProperty("SeedPositions")


def report(*_):
    values = [SEEDS.GetUncheckedElement(i) for i in range(SEEDS.GetNumberOfUncheckedElements())]
    part = os.environ["REPORT"] + ".part"
    with open(part, "w", encoding="utf-8") as file:
        json.dump(values, file)
    os.replace(part, os.environ["REPORT"])


SEEDS.AddObserver("UncheckedPropertyModifiedEvent", report)
report()
