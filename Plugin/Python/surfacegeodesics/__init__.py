"""The VTK classes of SurfaceGeodesics. They need VTK's Python modules, but not ParaView's."""

from .vtkFiltersGeodesics import *
from .vtkFiltersSurfaceGeodesics import *
from .vtkWidgetsTracing import *
