# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances and paths along surfaces: distance(), path(), and the VTK classes of SurfaceGeodesics.

They need VTK's Python modules, but not ParaView's.
"""

from .measure import distance, path
from .vtkFiltersGeodesics import *
from .vtkFiltersSurfaceGeodesics import *
from .vtkWidgetsTracing import *
