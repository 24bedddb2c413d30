# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time, memory and messages on an icosphere of 2.6 million points in slabs, or on the Bunny in boxes.

usage: mpiexec -n N --bind-to core pvbatch --sym Scaling.py OUR_PLUGIN [SUBDIVISIONS [OPTION ...]]
Of the Bunny, 3 subdivisions have 2.2 million points. Options:
    bunny   the Bunny instead of the sphere
    pole    the seed is far inside the first piece, from where the front reaches the others late, and not on a cut
    spread  with Spread Work
Times are of the filter alone: the first run, which also builds what is kept for the
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
OPTIONS = set(sys.argv[3:])
assert OPTIONS <= {"bunny", "pole", "spread"}, OPTIONS
IS_BUNNY, IS_POLE = "bunny" in OPTIONS, "pole" in OPTIONS
harness.load(PLUGIN)


def seed_on_bunny():
    """A point on the cuts of the boxes of two ranks, or the one that is farthest from them in the first."""
    points, cells = pieces.bunny()
    owner = pieces.owners(points, cells, "boxes", 2)
    first, second = (np.unique(cells[owner == rank]) for rank in range(2))
    on_cut = points[np.intersect1d(first, second)]
    if not IS_POLE:
        return on_cut[len(on_cut) // 2].tolist()
    distances = np.min([np.linalg.norm(points[first] - point, axis=1) for point in on_cut], axis=0)
    return points[first[distances.argmax()]].tolist()


SEED = seed_on_bunny() if IS_BUNNY else [-1, 0, 0] if IS_POLE else [0.0, 0.1, 1.0]


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
    OutputDataSetType="vtkPolyData",
    Script=harness.HERE + f"pieces.make_large{'_bunny' * IS_BUNNY}(self.GetOutput(), {SUBDIVISIONS})")
pieces_source.UpdatePipeline()
before = memory()
distance = simple.GeodesicDistance(Input=pieces_source, SeedPositions=SEED, SpreadWork="spread" in OPTIONS)
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
if points.GetNumberOfTuples() and not IS_BUNNY:
    x = harness.vtk_to_numpy(points)
    seed = np.array(SEED) / np.linalg.norm(SEED)
    truth = np.arctan2(np.linalg.norm(np.cross(x, seed), axis=1), x @ seed)
    values = harness.vtk_to_numpy(algorithm.GetOutputDataObject(0).GetPointData().GetArray("GeodesicDistance"))
    error = np.abs(values - truth).max()
rank = pieces.controller().GetLocalProcessId()
print(f"rank {rank}: {points.GetNumberOfTuples()} points, {grown:.0f} MB, largest error {error:.1e}", flush=True)
counts = {name: harness.informed(distance, name)
          for name in ("NumberOfRounds", "NumberOfUpdates", "LongestChainOfUpdates", "BytesExchanged", "MostPointsOnARank")}
pieces.controller().Barrier()
if harness.IS_FIRST:
    print(f"{harness.RANKS} ranks: first {first:.3f} s, again {sorted(times)[0]:.3f} s"
          f" ({', '.join(f'{t:.3f}' for t in times)});"
          f" rounds {counts['NumberOfRounds']}, updates {counts['NumberOfUpdates']},"
          f" longest chain {counts['LongestChainOfUpdates']},"
          f" bytes {counts['BytesExchanged']}, most points {counts['MostPointsOnARank']}", flush=True)
