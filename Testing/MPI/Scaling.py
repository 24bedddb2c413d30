# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time, memory and messages on an icosphere of 2.6 million points, cut into slabs.

usage: mpiexec -n N --bind-to core pvbatch --sym Scaling.py OUR_PLUGIN [SUBDIVISIONS [cut|pole]]
The seed is on the cut in the middle (the default), or at the pole inside the first slab, from where the front
reaches the others late. Times are of the filter alone: the first run, which also builds what is kept for the
surface (memory is what has been added after it), and the best of ten further ones.
"""

import ctypes
import os
import sys
import time

import numpy as np
from paraview import simple

sys.path.append(os.path.dirname(__file__))
import harness
import pieces

PLUGIN = sys.argv[1]
SUBDIVISIONS = int(sys.argv[2]) if len(sys.argv) > 2 else 9
SEED = [-1, 0, 0] if sys.argv[3:] == ["pole"] else [0.0, 0.1, 1.0]
harness.load(PLUGIN)


def memory():
    """Of this rank, in MB, without what is free."""
    ctypes.CDLL("libc.so.6").malloc_trim(0)
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1]) / 1024 for line in status if line.startswith("VmRSS"))


def timed(run):
    pieces.controller().Barrier()
    begin = time.perf_counter()
    run()
    pieces.controller().Barrier()
    return time.perf_counter() - begin


pieces_source = simple.ProgrammableSource(
    OutputDataSetType="vtkPolyData", Script=harness.HERE + f"pieces.make_large(self.GetOutput(), {SUBDIVISIONS})")
pieces_source.UpdatePipeline()
before = memory()
distance = simple.GeodesicDistance(Input=pieces_source, SeedPositions=SEED)
first = timed(distance.UpdatePipeline)
grown = memory() - before
algorithm = distance.GetClientSideObject()
# Asked directly, the source makes its piece once more.
algorithm.Modified()
algorithm.Update()
times = []
for _ in range(10):
    algorithm.Modified()
    times.append(timed(algorithm.Update))
points = algorithm.GetOutputDataObject(0).GetPoints().GetData()
error = 0.0
if points.GetNumberOfTuples():
    x = harness.vtk_to_numpy(points)
    seed = np.array(SEED) / np.linalg.norm(SEED)
    truth = np.arctan2(np.linalg.norm(np.cross(x, seed), axis=1), x @ seed)
    values = harness.vtk_to_numpy(algorithm.GetOutputDataObject(0).GetPointData().GetArray("GeodesicDistance"))
    error = np.abs(values - truth).max()
rank = pieces.controller().GetLocalProcessId()
print(f"rank {rank}: {points.GetNumberOfTuples()} points, {grown:.0f} MB, largest error {error:.1e}", flush=True)
counts = {name: harness.informed(distance, name)
          for name in ("NumberOfRounds", "NumberOfUpdates", "BytesExchanged", "MostPointsOnARank")}
pieces.controller().Barrier()
if harness.IS_FIRST:
    print(f"{harness.RANKS} ranks: first {first:.3f} s, again {sorted(times)[0]:.3f} s"
          f" ({', '.join(f'{t:.3f}' for t in times)});"
          f" rounds {counts['NumberOfRounds']}, updates {counts['NumberOfUpdates']},"
          f" bytes {counts['BytesExchanged']}, most points {counts['MostPointsOnARank']}", flush=True)
