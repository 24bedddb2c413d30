"""What the tests of this folder share."""

import os

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

DATA = os.path.join(os.path.dirname(__file__), "..", "Data")


def load(plugin):
    """Loads our plugin from its file; its proxies become functions of paraview.simple."""
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))


def bunny():
    return simple.XMLPolyDataReader(FileName=os.path.join(DATA, "Bunny.vtp"))


def output_of(proxy):
    """Runs a proxy and returns its output, as it is on the server."""
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def array_of(proxy, name="GeodesicDistance"):
    """The values of a point array of the output, None where there is no such array."""
    array = output_of(proxy).GetPointData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def points_of(proxy):
    return vtk_to_numpy(output_of(proxy).GetPoints().GetData())


def is_empty(proxy):
    proxy.UpdatePipeline()
    return proxy.GetDataInformation().GetNumberOfPoints() == 0


def informed(proxy, name):
    """The value of an information property after the last run."""
    proxy.UpdatePropertyInformation()
    return proxy.GetPropertyValue(name)
