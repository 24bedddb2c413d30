# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random cases on several ranks: each ends, with the result of one rank or with the same error on all ranks.

usage: mpiexec -n N pvbatch --sym Torture.py OUR_PLUGIN FIRST COUNT [NUMBER...]       (N > 1)
With TORTURE_VERBOSE set it prints each case before it runs; with TORTURE_HANG the last rank hangs in the first case.
Runs the cases FIRST to FIRST + COUNT - 1, and those with the other numbers. A case is the same for the same number and
N; those from LARGE on have so many points and seeds that fast marching takes these for dense. The plugin must be built
with SURFACEGEODESICS_INJECT_FAULTS. A case that does not end within a minute (or TORTURE_SECONDS) ends the run, with
the stacks of all ranks.
"""

import copy
import faulthandler
import os
import re
import signal
import subprocess
import sys
import time
import zlib

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkDummyController, vtkMultiProcessController

sys.path.append(os.path.dirname(__file__))
import harness
import pieces

PLUGIN, FIRST, COUNT = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
NUMBERS = [*range(FIRST, FIRST + COUNT), *map(int, sys.argv[4:])]
harness.load(PLUGIN)
RANK = pieces.controller().GetLocalProcessId()
RANKS = harness.RANKS
UNREACHED = 1e300
LARGE = 100000
SECONDS = int(os.environ.get("TORTURE_SECONDS", 60))
# pvbatch replaces sys.stderr by an object that has no file.
STDERR = os.fdopen(os.dup(2), "w")


def bent(points, random):
    """A grid's points on a wavy sheet, on a tube, or with edges whose lengths differ up to a thousand times."""
    kind = random.integers(4)
    x, y = points[:, 0], points[:, 1]
    if kind == 0:
        return np.stack([x, y, 0.1 * np.sin(7 * x) * np.cos(5 * y)], -1)
    if kind == 1:
        return np.stack([0.3 * np.cos(5 * x), 0.3 * np.sin(5 * x), y], -1)
    if kind == 2:
        return np.stack([x ** random.uniform(1, 4), y ** random.uniform(1, 2), 0 * x], -1)
    return np.stack([x, y, 0 * x], -1)


def grid_over(corner, width, rows, columns):
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    points = np.stack([i.ravel() / (rows - 1) * width, j.ravel() / (columns - 1)], -1)
    return points + [corner, 0.0], pieces.grid(rows, columns)


class Watchdog:
    """
    Ends this rank with its stacks if no case ends within a minute: those of gdb, and two minutes later Python's.
    No thread of Python could do it, as the rank holds Python's lock while it waits for others.
    """

    def __init__(self):
        stacks = f"gdb -p {os.getpid()} -batch -ex 'thread apply all backtrace' 2>/dev/null"
        script = (f"code=0; while [ $code -eq 0 ]; do read -t {SECONDS} line; code=$?; done; "
                  f"[ $code -gt 128 ] && {stacks} | sed 's/^/[rank {RANK}] /' >&2")
        self.process = subprocess.Popen(["bash", "-c", script], stdin=subprocess.PIPE, stderr=STDERR)

    def restart(self):
        faulthandler.dump_traceback_later(3 * SECONDS, exit=True, file=STDERR)
        self.process.stdin.write(b"\n")
        self.process.stdin.flush()

    def stop(self):
        faulthandler.cancel_dump_traceback_later()
        self.process.stdin.close()
        self.process.wait()


class Case:
    """A surface with the rank of each triangle, and a request on it."""

    def __init__(self, number):
        self.is_large = number >= LARGE
        self.random = np.random.default_rng([number, RANKS])
        self.more = np.random.default_rng([number, RANKS, 1])
        self.make_surface()
        self.make_arrays()
        self.make_request(number)

    def make_surface(self):
        random = self.random
        kind = random.choice(["grid", "grid", "strips", "strips", "torus", "sphere", "apart"])
        cut = random.choice(["slabs", "slabs", "random", "halves", "first", "last"])
        more = 60 if self.is_large else 0
        if kind == "torus":
            points, cells = pieces.torus(*(more + int(random.integers(3, most)) for most in (40, 20)))
        elif kind == "sphere":
            points, cells = pieces.sphere(int(random.integers(0, 4)) + (2 if self.is_large else 0))
        elif kind == "strips":
            # A rank each, of squares of very different sizes, that meet at some points only.
            points, cells, owner = [], [], []
            for rank in range(RANKS):
                rows, columns = (int(n) for n in random.choice([2, 2, 3, 5, 11, 41], 2))
                strip, corners = grid_over(rank, 1.0, rows, columns)
                cells.append(corners + sum(map(len, points)))
                points.append(strip)
                owner.append(np.full(len(corners), rank))
            points, cells = np.vstack(points), np.vstack(cells)
            points = np.column_stack([points / [RANKS, 1], np.zeros(len(points))])
            self.owner = np.concatenate(owner)
            points, cells = pieces.weld(points, cells)
        else:
            points, cells = grid_over(0.0, 1.0, *(more + int(random.integers(2, 50)) for _ in range(2)))
            points = bent(points, random)
            if kind == "apart":
                cells = np.vstack([cells, cells + len(points)])
                points = np.vstack([points, points + [3.0, 0.0, 0.0]])
        self.has_seams = kind == "strips"
        self.points, self.cells = np.asarray(points, float), np.asarray(cells)
        if kind != "strips":
            self.owner = pieces.owners(self.points, self.cells, cut, RANKS)
        if random.random() < 0.2:
            # A rank without a part of the surface.
            self.owner[self.owner == random.integers(RANKS)] = random.integers(RANKS)
        self.name = f"{kind} of {len(self.points)} points, cut {cut}"

    def make_arrays(self):
        random, count = self.random, len(self.points)
        kind = random.choice(["none", "none", "ranks", "lognormal", "bad"], p=[0.3, 0.3, 0.15, 0.2, 0.05])
        self.cost = None
        if kind == "ranks":
            # A cost each, up to a thousand times that of another; a shared point has that of the last rank.
            factors = 1000 ** random.random(RANKS)
            self.cost = np.ones(count)
            for rank in range(RANKS):
                self.cost[self.cells[self.owner == rank].ravel()] = factors[rank]
        elif kind != "none":
            self.cost = np.exp(random.normal(0.0, 1.0, count))
        if kind == "bad":
            self.cost[random.integers(count)] = -1.0
        part_of_wall = 0.003 if self.is_large else 0.05
        self.wall = random.random(len(self.cells)) < part_of_wall if random.random() < 0.25 else None
        self.has_ids = random.random() < 0.3
        self.has_ghosts = self.more.random() < 0.2
        self.name += (f", cost {kind}, wall {self.wall is not None}, ids {self.has_ids}, "
                      f"ghosts {self.has_ghosts}")

    def places(self, count):
        """Points in faces, and corners unless strips may touch there: such a point would be on two surfaces at once."""
        corners = self.points[self.cells[self.random.integers(len(self.cells), size=count)]]
        weights = self.random.dirichlet([0.5] * 3, count)
        if not self.has_seams:
            weights[self.random.random(count) < 0.3] = [1.0, 0.0, 0.0]
        return (corners * weights[:, :, None]).sum(1)

    def make_request(self, number):
        random = self.random
        self.is_path = random.random() < 0.3
        options = {}
        if self.is_path:
            options["WaypointPositions"] = self.places(int(random.integers(2, 5))).ravel().tolist()
            options["InterpolationOrder"] = int(random.random() < 0.8)
            options["HeightOffset"] = float(random.choice([0.0, 0.1]))
        else:
            options["ComputeNearestSeed"] = 1
            seeds = int(random.choice([1, 1, 2, 5, 40])) + (60 if self.is_large else 0)
            options["SeedPositions"] = self.places(seeds).ravel().tolist()
            if random.random() < 0.2:
                options.update(UseMaximumDistance=1, MaximumDistance=float(random.random()))
            if random.random() < 0.2:
                options["DestinationPositions"] = self.places(2).ravel().tolist()
        options["Method"] = str(random.choice(["FastMarching", "FastMarching", "FastMarching", "Dijkstra"]))
        if self.cost is not None:
            options["CostArray"] = ["POINTS", "Cost"]
        if self.wall is not None:
            options["BarrierArray"] = ["CELLS", "Wall"]
        self.line = None
        if random.random() < 0.15:
            self.line = self.places(2).ravel().tolist()
        self.line_property = "BarrierSource" if self.is_path else "SeedSource"
        if not self.is_path and self.line is None:
            options["SpreadWork"] = int(np.random.default_rng([number, RANKS, 2]).random() < 0.25)
        self.options = options
        self.culprit = int(random.integers(RANKS))
        self.fault = random.choice(["none", "other property", "abort", "error"], p=[0.74, 0.06, 0.08, 0.12])
        # The progress event at which the run is aborted, or the phase that fails.
        self.place = int(self.more.integers(1, 5 if self.fault == "abort" else 80))
        # Half of the aborts come in a phase instead.
        aborts = np.random.default_rng([number, RANKS, 3])
        if self.fault == "abort" and aborts.random() < 0.5:
            self.fault, self.place = "abort in phase", int(aborts.integers(1, 80))
        self.name += f", {options}, line {self.line}, fault {self.fault} at {self.place} on rank {self.culprit}"

    def data(self, owner):
        """The triangles of a rank, or all."""
        mine = np.flatnonzero(np.full(len(self.cells), True) if owner is None else self.owner == owner)
        ghosts = np.zeros(len(mine), np.uint8)
        if owner is not None and self.has_ghosts:
            # A layer of the other ranks' triangles round this rank's.
            beside = np.isin(self.cells, self.cells[mine]).any(1) & (self.owner != owner)
            ghosts = np.append(ghosts, np.full(beside.sum(), vtkDataSetAttributes.DUPLICATECELL, np.uint8))
            mine = np.append(mine, np.flatnonzero(beside))
        used, corners = np.unique(self.cells[mine], return_inverse=True)
        data = pieces.polydata(self.points[used], corners)

        def add(attributes, name, values):
            array = numpy_to_vtk(np.ascontiguousarray(values, float), deep=True)
            array.SetName(name)
            attributes.AddArray(array)

        add(data.GetPointData(), "PointNumber", used)
        if self.cost is not None:
            add(data.GetPointData(), "Cost", self.cost[used])
        if self.wall is not None:
            add(data.GetCellData(), "Wall", self.wall[mine])
        if self.has_ids:
            ids = numpy_to_vtkIdTypeArray((used * 3 + 10).astype(np.int64), deep=True)
            ids.SetName("GlobalIds")
            data.GetPointData().SetGlobalIds(ids)
        if ghosts.any():
            array = numpy_to_vtk(ghosts, deep=True)
            array.SetName("vtkGhostType")
            data.GetCellData().AddArray(array)
        return data

    def with_seed(self, number):
        """The case with only one of its seeds; that of a line comes after the positions."""
        case = copy.copy(self)
        positions = self.options["SeedPositions"][3 * number:3 * number + 3]
        case.options = dict(self.options, SeedPositions=positions)
        case.line = None if positions else self.line
        return case

    def fields_of_path(self):
        """For each waypoint the case of the distances from it, by which paths are found."""
        kept = ("Method", "CostArray", "BarrierArray")
        positions = self.options["WaypointPositions"]
        for i in range(0, len(positions), 3):
            case = copy.copy(self)
            case.is_path, case.fault = False, "none"
            case.options = {name: self.options[name] for name in kept if name in self.options}
            case.options.update(SeedPositions=positions[i:i + 3], ComputeNearestSeed=1)
            yield case

    def nudged(self):
        """Changes what paths depend on by as much as rounding does."""
        if self.cost is not None:
            self.cost = self.cost * (1.0 + 1e-13 * self.more.normal(size=len(self.cost)))
        else:
            self.points = self.points * (1.0 + 1e-13 * self.more.normal(size=self.points.shape))
        return self


class Run:
    """A run of a case on this rank: with the part of a rank, or with all of the surface and no other rank."""

    def __init__(self, case, owner, fault="none"):
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(case.data(owner))
        options = dict(case.options)
        if fault == "other property":
            options["MergeCoincidentPoints"] = 0
        proxies = [source]
        if case.line is not None:
            proxies.append(simple.PolyLineSource(Points=case.line))
            options[case.line_property] = proxies[-1]
        make = simple.GeodesicPath if case.is_path else simple.GeodesicDistance
        proxies.append(make(Input=source, **options))
        proxies[-1].UpdateVTKObjects()
        algorithm = proxies[-1].GetClientSideObject()
        self.messages_of_fault = None
        self.was_aborted = False
        if case.fault in ("abort", "abort in phase", "error") and owner is not None:
            self.messages_of_fault = self.run_with_fault(algorithm, case, fault)
        self.messages = harness.messages_of(algorithm.Update)
        self.output = algorithm.GetOutputDataObject(0)
        self.values = self.lengths_of_path() if case.is_path else self.distances(len(case.points))
        self.seeds = None if case.is_path else self.nearest_seeds(len(case.points))
        for proxy in reversed(proxies):
            simple.Delete(proxy)

    def run_with_fault(self, algorithm, case, fault):
        """Runs with a fault on this rank, or without one, and makes the filter run once more at the next update."""
        left = [case.place]

        def abort(*_):
            left[0] -= 1
            if left[0] == 0:
                algorithm.AbortExecuteOn()

        if fault == "abort":
            observer = algorithm.AddObserver("ProgressEvent", abort)
        elif fault == "abort in phase":
            # Python handles a signal when it runs next, here as the observer of the next event.
            phases = []
            handler = signal.signal(signal.SIGUSR1, lambda *_: phases.append(case.place))
            observer = algorithm.AddObserver("ProgressEvent", lambda *_: phases and algorithm.AbortExecuteOn())
            os.environ["SURFACEGEODESICS_ABORT"] = str(case.place)
        elif fault == "error":
            os.environ["SURFACEGEODESICS_FAULT"] = str(case.place)
        messages = harness.messages_of(algorithm.Update)
        if fault in ("abort", "abort in phase"):
            self.was_aborted = bool(algorithm.GetAbortExecute())
            algorithm.RemoveObserver(observer)
            algorithm.AbortExecuteOff()
        os.environ.pop("SURFACEGEODESICS_FAULT", None)
        if os.environ.pop("SURFACEGEODESICS_ABORT", None):
            signal.signal(signal.SIGUSR1, handler)
        algorithm.Modified()
        return messages

    def distances(self, size):
        """The least and the largest distance at each point of this rank; -inf and inf elsewhere."""
        least, most = np.full(size, np.inf), np.full(size, -np.inf)
        array = self.output.GetPointData().GetArray("GeodesicDistance")
        if array:
            numbers = vtk_to_numpy(self.output.GetPointData().GetArray("PointNumber")).astype(int)
            np.minimum.at(least, numbers, vtk_to_numpy(array))
            np.maximum.at(most, numbers, vtk_to_numpy(array))
        return np.concatenate([least, -most])

    def nearest_seeds(self, size):
        """The least and the largest number of the nearest seed at each point of this rank, as distances() has them."""
        least, most = np.full(size, np.inf), np.full(size, -np.inf)
        array = self.output.GetPointData().GetArray("NearestSeed")
        if array:
            numbers = vtk_to_numpy(self.output.GetPointData().GetArray("PointNumber")).astype(int)
            np.minimum.at(least, numbers, vtk_to_numpy(array))
            np.maximum.at(most, numbers, vtk_to_numpy(array))
        return np.concatenate([least, -most])

    def lengths_of_path(self):
        array = self.output.GetCellData().GetArray("Length")
        lengths = np.full(8, np.inf)
        if array:
            lengths[:array.GetNumberOfTuples()] = vtk_to_numpy(array)
        return lengths


def least_of_ranks(values):
    own, least = numpy_to_vtk(np.ascontiguousarray(values), deep=True), vtkDoubleArray()
    least.SetNumberOfTuples(len(values))
    pieces.controller().AllReduce(own, least, vtkCommunicator.MIN_OP)
    return vtk_to_numpy(least)


def run_alone(case):
    """The whole surface on this rank, which then sees no other one."""
    together = vtkMultiProcessController.GetGlobalController()
    vtkMultiProcessController.SetGlobalController(vtkDummyController())
    try:
        return Run(case, None)
    finally:
        vtkMultiProcessController.SetGlobalController(together)


def require_same_on_all(number, case, messages):
    """All ranks have the same messages, but for the addresses of their filters."""
    text = zlib.crc32(re.sub(r"0x[0-9a-f]+", "", messages).encode())
    of_all = least_of_ranks([float(text), -float(text)])
    assert of_all[0] == -of_all[1], (number, case.name, "not the same error on all ranks", messages)


def reached(values):
    return np.isfinite(values) & (np.abs(values) < UNREACHED)


def without_ties_at_the_end(case, values, truth):
    """
    What is reached without the points as far as a destination or the maximum distance, to rounding: rounding decides
    whether these are reached.
    """
    hasEnd = not case.is_path and ("DestinationPositions" in case.options or "MaximumDistance" in case.options)
    most = np.abs(truth[reached(truth)]).max(initial=0)
    is_last = [reached(found) & (np.abs(found) >= (1.0 - 1e-12) * most) for found in (values, truth)]
    is_tie = hasEnd & (reached(values) != reached(truth)) & np.logical_or(*is_last)
    return np.where(is_tie, np.inf, values), np.where(is_tie, np.inf, truth)


def difference(values, truth):
    """The largest difference of what is reached, relative to the largest value; None if not the same is reached."""
    isReached = reached(truth)
    if not np.array_equal(isReached, reached(values)):
        return None
    return np.abs(values[isReached] - truth[isReached]).max(initial=0) / max(np.abs(truth[isReached]).max(initial=0), 1e-300)


def require_nearest_seeds(number, case, seeds, alone):
    """Nearest seeds are those of one rank, but where two seeds are equally far."""
    size = len(case.points)
    truth, isReached = alone.values[:size], reached(alone.values[:size])
    largest = np.abs(truth[isReached]).max(initial=0)
    for found in (seeds[:size], -seeds[size:]):
        others = np.flatnonzero(isReached & (found != alone.seeds[:size]) & np.isfinite(found) & (found >= 0))
        for seed in np.unique(found[others]):
            points = others[found[others] == seed]
            lengths = run_alone(case.with_seed(int(seed))).values[points]
            excess = np.abs(lengths - truth[points]).max() / max(largest, 1e-300)
            assert excess <= 1e-9, (number, case.name, "nearest seed", int(seed), "at", points, "is farther by", excess)


def is_unsettled(*runs):
    """Whether a march ended at the limit of its updates, or settled only roughly, so that its order matters."""
    return any(words in run.messages for run in runs for words in ("does not settle", "settled only roughly"))


def require_same_fields(number, case):
    """The fields that lead a path are those of one rank, so that another way is not a sign of another field."""
    for field in case.fields_of_path():
        several = Run(field, RANK)
        values = least_of_ranks(several.values)
        alone = run_alone(field)
        if not is_unsettled(several, alone):
            error = difference(values, alone.values)
            assert error is not None and error <= 1e-9, (number, field.name, "field of a path", field.options, error)


def check(number):
    """Returns how the case ended. All ranks have the same values, so that they fail at once or not at all."""
    case = Case(number)
    several = Run(case, RANK, case.fault if RANK == case.culprit else "none")
    values = least_of_ranks(several.values)
    seeds = None if case.is_path else least_of_ranks(several.seeds)
    require_same_on_all(number, case, several.messages)
    end = ""
    if several.messages_of_fault is not None:
        require_same_on_all(number, case, several.messages_of_fault)
        if "A fault was injected" in several.messages_of_fault:
            end = " after injected error"
    if least_of_ranks([-float(several.was_aborted)])[0] < 0:
        end = " after abort"
    alone = run_alone(case)
    if case.fault == "other property":
        assert "same on all ranks" in several.messages, (number, case.name, several.messages)
        return "other property"
    if is_unsettled(several, alone):
        # On the slivers that a line cuts. How far a march is from the limit of its updates depends on its order.
        return "unsettled" + end
    hasFailed = several.messages != ""
    assert hasFailed == (alone.messages != ""), (number, case.name, several.messages, alone.messages)
    if hasFailed and not case.is_path:
        assert not np.isfinite(values).any(), (number, case.name, "a field beside an error", several.messages)
        return "error" + end
    error = difference(*without_ties_at_the_end(case, values, alone.values))
    # Straightened paths end a little apart.
    limit = 1e-6 if case.is_path else 1e-9
    if case.is_path and (error is None or error > limit):
        # Where two ways are equally good to rounding, which one is traced is rounding's choice on one rank as well, as
        # long as the fields are the same.
        require_same_fields(number, case)
        for _ in range(20):
            other = difference(values, run_alone(case.nudged()).values)
            if other is not None and other <= limit:
                if harness.IS_FIRST:
                    print(f"case {number}: another way, {error} longer or shorter", flush=True)
                return "other way" + end
    assert error is not None, (number, case.name, "reached")
    assert error <= limit, (number, case.name, "error", error)
    if not case.is_path:
        require_nearest_seeds(number, case, seeds, alone)
    return ("error" if hasFailed else "path" if case.is_path else "field") + end


counts = {}
watchdog = Watchdog()
for number in NUMBERS:
    if harness.IS_FIRST and os.environ.get("TORTURE_VERBOSE"):
        print(number, Case(number).name, flush=True)
    watchdog.restart()
    if os.environ.get("TORTURE_HANG") and RANK == RANKS - 1:
        time.sleep(1e6)
    try:
        result = check(number)
    except AssertionError as failure:
        print(failure, file=STDERR, flush=True)
        result = "failed"
    counts[result] = counts.get(result, 0) + 1
watchdog.stop()
for fault in ("injected error", "abort"):
    assert COUNT < 200 or any(kind.endswith(fault) for kind in counts), f"no {fault} in any case"
if harness.IS_FIRST:
    print(f"{len(NUMBERS)} cases on {RANKS} ranks ended:", ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items())))
if "failed" in counts:
    sys.exit(1)
