# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The VTK classes of SurfaceGeodesics. They need VTK's Python modules, but not ParaView's."""

from .vtkFiltersGeodesics import *
from .vtkFiltersSurfaceGeodesics import *
from .vtkWidgetsTracing import *
