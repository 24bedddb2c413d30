# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The article's two programs: their help and errors, its scenarios, and a real mouse.

usage: Programs.py PROGRAMS SCENARIOS.sh BUNNY.vtp FOLDER
"""

import os
import subprocess
import sys
import time

import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from surfacegeodesics import vtkFastMarchingGeodesicDistance

import numpy

programs, scenarios, bunny, folder = sys.argv[1:5]
os.makedirs(folder, exist_ok=True)
os.chdir(folder)
environment = os.environ | {"PATH": programs + ":" + os.environ["PATH"]}
distance_program = os.path.join(programs, "GeodesicDistanceExample")
path_program = os.path.join(programs, "GeodesicPathExample")
# Points of the Bunny.
nose, ear, tail = 17857, 10860, 2513


def run(*arguments):
    return subprocess.run(
        arguments, env=environment, capture_output=True, text=True, timeout=120, check=False)


def read(file):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def array(surface, name):
    return vtk_to_numpy(surface.GetPointData().GetArray(name))


def check_help():
    for program, options in (
        (distance_program, ("--maxDist", "--propagationWts", "--exclusionContour")),
        (path_program, ("method", "order", "heightOffset")),
    ):
        result = run(program, "--help")
        assert result.returncode == 0, result
        for option in options + ("usage:", "--seed", "--events", "--record", "--screenshot"):
            assert option in result.stdout, option


def check_errors():
    for program, arguments, message in (
        (path_program, [], "Arguments given: 0, needed: 1 to 4."),
        (path_program, [bunny, "1", "1", "0", "9"], "Arguments given: 5"),
        (path_program, [bunny, "2"], 'The method is "2"; it must be 0 or 1'),
        (path_program, [bunny, "1", "x"], 'The order is "x"'),
        (path_program, [bunny, "0", "1"], "give method 1"),
        (path_program, [bunny, "1", "1", "high"], 'The height offset is "high"'),
        (path_program, ["missing.vtp"], "missing.vtp does not exist"),
        (path_program, [scenarios, "--seed", "0"], "holds no surface"),
        (path_program, [bunny, "--seed", "99999999"], "There is no point 99999999"),
        (path_program, [bunny, "--seed", "1.5"], '"1.5", which is no point id'),
        (path_program, [bunny, "--seed"], "--seed needs a value"),
        (path_program, [bunny, "--sed", "1"], "--sed is not known"),
        (path_program, [bunny, "--events", "missing.events"], "missing.events does not exist"),
        (path_program, [bunny, "--seed", "0", "--screenshot", "/no/such.png"], "cannot be written"),
        (distance_program, [bunny], "Arguments given: 1, needed: 2."),
        (distance_program, [bunny, "out.vtp", "--maxDist", "far"], '"far", which is no number'),
        (distance_program, [bunny, "out.vtp", "--maxDist", "-1"], "must not be negative"),
        (distance_program, [bunny, "out.vtp", "--propagationWts", "Heat"], 'no point array "Heat"'),
        (distance_program, [bunny, "/no/such.vtp", "--seed", "0"], "cannot be written"),
        (distance_program, [bunny, "out.vtp", "--seed", "-4"], "Seed point id -4"),
        (distance_program, [bunny, "out.vtp", "--seed", "0", "--exclusionContour"], "not closed"),
    ):
        result = run(program, *arguments)
        assert result.returncode == 1, (arguments, result)
        assert message in result.stderr, (arguments, result.stderr)


def check_picture(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions() == (640, 480, 1), file
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    colors, counts = numpy.unique(pixels, axis=0, return_counts=True)
    assert len(colors) > 500, file
    # On white, with nothing cut off.
    rows = pixels.reshape(480, 640, -1)
    border = numpy.concatenate([rows[0], rows[-1], rows[:, 0], rows[:, -1]])
    assert (border == 255).all(), file
    return {tuple(c): n for c, n in zip(colors, counts)}


def check_scenarios():
    result = run("bash", scenarios, bunny, ".")
    assert result.returncode == 0, result
    distance = array(read("distance.vtp"), "FMMDist")
    assert distance[nose] == 0
    used = distance >= 0
    assert used.sum() == 34834

    maximum = array(read("maximum.vtp"), "FMMDist")
    near = used & (distance <= 0.08)
    assert (maximum[~near] == -1).all()
    assert numpy.abs(maximum[near] - distance[near]).max() < 1e-9

    # The mean curvature at the ends of the half axes 1, 0.6 and 0.4.
    ellipsoid = read("Ellipsoid.vtp")
    points = vtk_to_numpy(ellipsoid.GetPoints().GetData())
    curvature = array(ellipsoid, "Curvature")
    axes = numpy.array([1, 0.6, 0.4])
    assert numpy.abs(((points / axes) ** 2).sum(axis=1) - 1).max() < 1e-12
    for i in range(3):
        end = numpy.argmax(points[:, i])
        others = numpy.delete(axes, i)
        truth = axes[i] * (1 / others**2).sum() / 2
        assert abs(curvature[end] / truth - 1) < 1e-3, (i, curvature[end], truth)
    assert curvature.min() > 0
    weighted = vtkFastMarchingGeodesicDistance()
    weighted.SetInputData(ellipsoid)
    weighted.SetFieldDataName("d")
    weighted.SetPropagationWeights(ellipsoid.GetPointData().GetArray("Curvature"))
    seeds = vtkIdList()
    seeds.InsertNextId(3582)
    weighted.SetSeeds(seeds)
    weighted.Update()
    assert (array(weighted.GetOutput(), "d") == array(read("weights.vtp"), "FMMDist")).all()

    # Within the contour distances can only be longer, beyond it there are none.
    head = array(read("head.vtp"), "FMMDist")
    assert head[nose] == 0 and head[ear] > 0 and head[tail] == -1
    inside = head >= 0
    assert 8000 < inside.sum() < 10000
    assert (head[inside] >= distance[inside] * (1 - 1e-9)).all()

    last_of_dijkstra, last_of_fast_marching = [
        line for line in result.stdout.splitlines() if ", closed, length " in line]
    nodes_of = lambda line: line.partition(",")[0]
    length_of = lambda line: float(line.rpartition(" ")[2])
    assert nodes_of(last_of_dijkstra) == nodes_of(last_of_fast_marching)
    assert length_of(last_of_fast_marching) < 0.97 * length_of(last_of_dijkstra)

    for name in ("distance", "maximum", "weights", "head", "dijkstra", "fast-marching"):
        check_picture(name + ".png")


def xdotool(*arguments, check=True):
    subprocess.run(("xdotool",) + arguments, check=check)


def wait_for_line(process, marker):
    """The next line: it comes when the program has answered to the mouse."""
    line = process.stdout.readline()
    assert marker in line, line
    return line


def check_mouse():
    """By hand, and the recording of it once more."""
    process = subprocess.Popen(
        [path_program, bunny, "1", "1", "--record", "mouse.events"],
        env=environment, stdout=subprocess.PIPE, text=True)
    window = subprocess.run(
        ["xdotool", "search", "--sync", "--name", "Geodesic path"],
        check=True, capture_output=True, text=True).stdout.split()[0]
    # The window is there before the program listens.
    time.sleep(2)
    for count, (x, y) in enumerate(((154, 208), (430, 300), (250, 300)), start=1):
        xdotool("mousemove", "--window", window, str(x), str(y))
        xdotool("click", "1")
        assert len(wait_for_line(process, "nodes ").partition(",")[0].split()) == count + 1
    xdotool("key", "--window", window, "z")
    by_hand = wait_for_line(process, "nodes ")
    assert len(by_hand.partition(",")[0].split()) == 3
    # The window closes at the press, so there is none for the release.
    xdotool("key", "--window", window, "q", check=False)
    assert process.wait(60) == 0
    again = run(path_program, bunny, "1", "1", "--events", "mouse.events")
    assert again.returncode == 0, again
    assert again.stdout.splitlines()[-1] + "\n" == by_hand, (again.stdout, by_hand)


check_help()
check_errors()
check_scenarios()
check_mouse()
