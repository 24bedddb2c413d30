# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The path of PathOnPlane.py, shown."""

import os

from paraview.simple import *

exec(open(os.path.join(os.environ["PYTHONPATH"], "PathOnPlane.py"), encoding="utf-8").read())
Show(GetActiveSource(), view)
Render()
