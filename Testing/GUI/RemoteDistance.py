# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ball of Ball.py on a server that draws, closed, and the filter on it, not applied.

The ranks' parts of the source differ by rounding where they meet, which is a gap.
"""

import os

from paraview.simple import *

exec(open(os.path.join(os.environ["PYTHONPATH"], "RemoteBall.py"), encoding="utf-8").read())
Delete(GetActiveSource())
Hide(ball, view)
ROUNDED = "floor(coords{0} * 65536 + 0.5) / 65536 * {1}Hat"
closed = Calculator(
    registrationName="Closed", Input=ball, CoordinateResults=1,
    Function=" + ".join(ROUNDED.format(*axis) for axis in (("X", "i"), ("Y", "j"), ("Z", "k"))))
Show(closed, view)
SetActiveSource(GeodesicDistance(registrationName="Distance", Input=closed))
Render()
