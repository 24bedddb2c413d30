# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The closed ball of RemoteDistance.py, and a path on it, not applied."""

import os

from paraview.simple import *

exec(open(os.path.join(os.environ["PYTHONPATH"], "RemoteDistance.py"), encoding="utf-8").read())
Delete(GetActiveSource())
SetActiveSource(GeodesicPath(registrationName="Path", Input=closed))
Render()
