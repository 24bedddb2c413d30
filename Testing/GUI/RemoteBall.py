# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ball.py on a server that draws."""

import os

from paraview.simple import *

exec(open(os.path.join(os.environ["PYTHONPATH"], "Ball.py"), encoding="utf-8").read())
view.RemoteRenderThreshold = 0
Render()
