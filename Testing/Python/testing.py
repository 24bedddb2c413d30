# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of this folder share."""

import os

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

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


def cells_of(proxy):
    """The corners of the cells of a surface of triangles."""
    return vtk_to_numpy(output_of(proxy).GetPolys().GetConnectivityArray()).reshape(-1, 3)


def with_arrays(proxy, points=None, cells=None):
    """A source of the proxy's output with these arrays, {name: values}, on its points and cells."""
    data = output_of(proxy)
    for attributes, arrays in ((data.GetPointData(), points), (data.GetCellData(), cells)):
        for name, values in (arrays or {}).items():
            array = numpy_to_vtk(np.asarray(values, float), deep=True)
            array.SetName(name)
            attributes.AddArray(array)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def polyline(points, closed=False):
    return simple.PolyLineSource(Points=np.ravel(points).tolist(), Closed=closed)


def is_empty(proxy):
    proxy.UpdatePipeline()
    return proxy.GetDataInformation().GetNumberOfPoints() == 0


def messages_of(run):
    """What is reported as errors or warnings while a function runs."""
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    run()
    vtkOutputWindow.SetInstance(None)
    return window.GetOutput()


def expect_error(proxy, *named):
    """The output is empty, and the message names all of these."""
    messages = messages_of(proxy.UpdatePipeline)
    assert is_empty(proxy), named
    for words in named:
        assert words in messages, (words, messages)


def informed(proxy, name):
    """The value of an information property after the last run."""
    proxy.UpdatePropertyInformation()
    return proxy.GetPropertyValue(name)
