"""Every rank refuses a surface that is spread over several, with the same message and no deadlock.

usage: mpiexec -n 2 pvbatch --sym OnSeveralRanks.py OUR_PLUGIN
"""

import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import testing

testing.load(sys.argv[1])
controller = vtkMultiProcessController.GetGlobalController()
assert controller.GetNumberOfProcesses() == 2

distance = simple.GeodesicDistance(Input=simple.Sphere(), SeedPositions=[0, 0, 0.5])
window = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(window)
distance.UpdatePipeline()
vtkOutputWindow.SetInstance(None)
assert "spread over 2 ranks" in window.GetOutput(), window.GetOutput()
output = distance.GetClientSideObject().GetOutputDataObject(0)
assert output.GetNumberOfPoints() == 0
controller.Barrier()
