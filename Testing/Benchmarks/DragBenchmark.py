# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""How many pictures a second a drag with live update gives, in ParaView's own window with a pointer that moves all the
time.

usage: bash Testing/Support/with_display.sh 1366x768 python3 DragBenchmark.py PARAVIEW [CASE...] [--profile]

A case is distance or path, and the number of points, as in path:1000000; without any, those of the pages are measured.
Needs PV_PLUGIN_CONFIG_FILE. Prints the pictures a second, and of each picture the time, the processor time of ParaView
on all cores, and the time of the filter, in ms. With --profile it also prints, by perf's samples, what processor time
of a picture the parts take that PARTS names; a part does not count what it calls of the parts above it.
"""

import collections
import os
import re
import subprocess
import sys
import tempfile
import time

import numpy as np

from Window import VIEW, Screen, start

PARAVIEW, *CASES = sys.argv[1:]
PROFILE = "--profile" in CASES
CASES = [case for case in CASES if case != "--profile"] or ["distance:160000", "path:160000", "path:1000000"]
COLORS = {"distance": (230, 76, 26), "path": (0, 140, 89)}
SECONDS = 10
# What a stack's innermost function must contain to count for a part.
PARTS = [
    ("rasterising, Mesa's own threads", r"^llvmpipe-"),
    ("drawing calls, Mesa", r"swrast_dri|libgallium|libGLX_mesa|libLLVM|\(/tmp/|\[JIT\]|\[unknown\].*anon"),
    ("the filter: march and path", r"geodesic::|libvtkFiltersSurface"),
    ("bounds of cells", r"ComputeCellsBounds|vtkBoundingBox"),
    ("buffers: colours", r"MapScalars|MapScalarsToTexture|UploadDataArray"),
    ("buffers: all", r"BuildBufferObjects|BuildAllVBOs|BuildIBO"),
    ("shaders", r"UpdateShaders|vtkShaderProgram"),
    ("geometry for the view", r"vtkPVGeometryFilter|MultiBlockMaker"),
    ("ranges and summaries of the data", r"vtkPVDataInformation|vtkPVArrayInformation|GetRange|ComputeScalarRange"),
    ("the panel", r"SurfaceSeeds|seeds::"),
    ("copying the picture to the window", r"ReadPixels|QOpenGL|QVTKOpenGL|paintGL|BlitDisplay|Frame\b.*libvtkRenderingOpenGL2"),
    ("the rest of drawing", r"vtkRenderer::|vtkRenderWindow|vtkPVRenderView"),
]


def read(log, begin, end):
    with open(log, encoding="utf-8") as file:
        lines = [line.split() for line in file]
    return [(event, float(moment), float(spent)) for event, moment, spent in lines if begin < float(moment) < end]


def marker_near(place, color):
    """The middle of the marker nearest to a place of the screen: where the view is depends on the version."""
    places = np.column_stack(screen.places_of(color))
    away = np.hypot(*(places - place).T)
    nearest = places[away.argmin()]
    return places[np.hypot(*(places - nearest).T) < 15].mean(axis=0).round().astype(int).tolist()


def drag(marker, seconds):
    """Moves the pressed pointer from a marker along a curve for so many seconds; returns when it began."""
    screen.move(*marker)
    screen.button(1)
    begin = time.perf_counter()
    step = 0
    while time.perf_counter() - begin < seconds:
        step += 1
        angle = 0.01 * step
        screen.move(marker[0] + int(100 * np.sin(angle)), marker[1] + int(60 * np.sin(0.7 * angle)))
        time.sleep(0.01)
    screen.button(0)
    return begin


def report(case, events):
    # Each run is drawn: as a sketch over the view, or by the view itself.
    solved = [(moment, spent) for event, moment, spent in events if event == "solved"][1:]
    pictures = len(solved) - 1
    assert pictures > 0, f"{case}: the drag gave no pictures"
    # A run that is aborted begins and does not end.
    solving = sum(end[1] - begin[1] for begin, end in zip(events, events[1:])
                  if (begin[0], end[0]) == ("solve", "solved") and begin[1] >= solved[0][0])
    elapsed, spent = np.subtract(solved[-1], solved[0])
    print(f"{case}: {pictures / elapsed:.1f} pictures a second; each {1000 * elapsed / pictures:.0f} ms, "
          f"{1000 * spent / pictures:.0f} ms of processor time, the filter's {1000 * solving / pictures:.0f} ms")
    return 1000 * spent / pictures


def stacks(data):
    """The samples of perf: their thread, and their functions from the innermost on."""
    text = subprocess.run(["perf", "script", "-i", data, "-F", "comm,ip,sym,dso"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, check=True).stdout.decode(errors="replace")
    for sample in text.split("\n\n"):
        lines = [line.strip() for line in sample.strip().split("\n")]
        if lines[0]:
            yield lines


def part_of(stack):
    for name, pattern in PARTS:
        if any(re.search(pattern, line) for line in stack):
            return name
    return "everything else"


def print_profile(data, milliseconds):
    counts = collections.Counter(part_of(stack) for stack in stacks(data))
    total = sum(counts.values())
    for name, count in counts.most_common():
        print(f"  {milliseconds * count / total:6.1f} ms  {name}")


def measure(case):
    kind, points = case.split(":")
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "log")
        paraview = start(PARAVIEW, "DragInside.py", folder, KIND=kind, POINTS=points, LOG=log)
        while not os.path.exists(log) or len(screen.places_of(COLORS[kind])[0]) < 20:
            time.sleep(0.1)
            assert paraview.poll() is None, "ParaView has ended"
        time.sleep(5)
        perf = []
        if PROFILE:
            perf = ["perf", "record", "-q", "-F", "499", "-g", "-p", str(paraview.pid), "-o", os.path.join(folder, "perf")]
            perf = [subprocess.Popen(perf)]
        begin = drag(marker_near(VIEW, COLORS[kind]), SECONDS)
        for process in perf:
            process.terminate()
            process.wait()
        time.sleep(2)
        events = read(log, begin, begin + SECONDS)
        spent = report(case, events)
        if PROFILE:
            print_profile(os.path.join(folder, "perf"), spent)
        paraview.kill()
        paraview.wait()


screen = Screen()
for each in CASES:
    measure(each)
