# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long a user waits for the SurfaceSeeds widget, measured from outside: an event is given to the X server, and the
time counts until the pixels change.

usage: xvfb-run -a -s "-screen 0 1366x768x24" python3 PickingBenchmark.py PARAVIEW [URL]

Needs PV_PLUGIN_CONFIG_FILE. With the URL of a ParaView server, that one has the data and draws them.
Prints, in ms, on 1M triangles and with a still camera: the marker that follows the pointer, and a seed's row in the
table after a click and after Ctrl+click; then the updates a second of a drag on 160k points with live update, and
which part of them is the filter's and which the view's.
"""

import ctypes
import json
import os
import random
import subprocess
import sys
import tempfile
import time

import numpy as np

PARAVIEW, *URL = sys.argv[1:]
HERE = os.path.dirname(os.path.abspath(__file__))
ORANGE = (230, 76, 26)
WIDTH, HEIGHT = 1366, 768
VIEW = 832, 467
CONTROL = 37


class Image(ctypes.Structure):
    """The beginning of XImage."""

    _fields_ = [
        ("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int),
        ("format", ctypes.c_int), ("data", ctypes.c_void_p), ("byte_order", ctypes.c_int),
        ("bitmap_unit", ctypes.c_int), ("bitmap_bit_order", ctypes.c_int),
        ("bitmap_pad", ctypes.c_int), ("depth", ctypes.c_int), ("bytes_per_line", ctypes.c_int)]


class Screen:
    """The X server, by its own libraries: starting a program for each event would take longer than what is measured."""

    def __init__(self):
        self.x = ctypes.CDLL("libX11.so.6")
        self.test = ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x.XGetImage.restype = ctypes.POINTER(Image)
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))

    def grab(self, x, y, width, height):
        image = self.x.XGetImage(
            self.display, self.root, x, y, width, height, ctypes.c_ulong(0xFFFFFFFF), 2)
        pixels = ctypes.string_at(image.contents.data, image.contents.bytes_per_line * height)
        self.x.XFree(ctypes.c_void_p(image.contents.data))
        self.x.XFree(image)
        return pixels

    def move(self, x, y):
        self.test.XTestFakeMotionEvent(self.display, -1, x, y, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)

    def button(self, is_down):
        self.test.XTestFakeButtonEvent(self.display, 1, is_down, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)

    def click(self):
        self.button(1)
        self.button(0)

    def control(self, is_down):
        self.test.XTestFakeKeyEvent(self.display, CONTROL, is_down, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)

    def time_until_changed(self, region, cause):
        before = self.grab(*region)
        start = time.perf_counter()
        cause()
        while time.perf_counter() - start < 30:
            if self.grab(*region) != before:
                return 1000 * (time.perf_counter() - start)
        sys.exit("Nothing changed on the screen within 30 s")

    def places_of(self, color):
        pixels = np.frombuffer(self.grab(0, 0, WIDTH, HEIGHT), np.uint8).reshape(HEIGHT, WIDTH, 4)
        y, x = np.nonzero((abs(pixels[:, :, 2::-1].astype(int) - color) < 4).all(axis=2))
        return x, y


SETTINGS = """[General]
GeneralSettings.ShowWelcomeDialog=0
[SurfaceSeeds]
LiveUpdate=true
"""


def start(triangles, live, folder):
    log = os.path.join(folder, "log.json")
    os.makedirs(os.path.join(folder, "ParaView"))
    with open(os.path.join(folder, "ParaView", "ParaView5.11.0.ini"), "w", encoding="utf-8") as file:
        file.write(SETTINGS)
    process = subprocess.Popen(
        [PARAVIEW, *(f"--url={url}" for url in URL), "-qwindowgeometry", f"{WIDTH}x{HEIGHT}+0+0",
         "--script=" + os.path.join(HERE, "PickingInside.py")],
        env={**os.environ, "TRIANGLES": str(triangles), "LIVE": str(live), "LOG": log,
             "XDG_CONFIG_HOME": folder},
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while not os.path.exists(log):
        time.sleep(0.1)
    while len(screen.places_of(ORANGE)[0]) < 20:
        time.sleep(0.1)
    time.sleep(3)
    return process, log


def report(what, times):
    print(f"{what}: median {np.median(times):.0f} ms, worst of {len(times)} {max(times):.0f} ms")


def places(count):
    """Places on the ball that are no nearer to each other than markers reach."""
    found = []
    while len(found) < count:
        place = np.array([VIEW[0] + random.randint(-110, 110), VIEW[1] + random.randint(-110, 110)])
        if all(abs(place - other).max() > 20 for other in found):
            found.append(place)
    return [tuple(int(c) for c in place) for place in found]


def measure_picks():
    x, y = screen.places_of(ORANGE)
    button = int(x.mean()), int(y.mean())
    table = 12, button[1] + 50, 240, 120
    screen.move(*button)
    screen.click()
    screen.move(*VIEW)
    time.sleep(5)
    report("Preview", [
        screen.time_until_changed((x - 12, y - 12, 24, 24), lambda: (screen.move(x, y), None)[1])
        for x, y in places(30) if not time.sleep(0.3)])
    places_of_clicks = places(20)
    for what, control, part in (
            ("Click to row", 0, places_of_clicks[::2]), ("Ctrl+click to row", 1, places_of_clicks[1::2])):
        times = []
        for place in part:
            screen.move(*place)
            if control:
                screen.control(1)
            time.sleep(0.5)
            times.append(screen.time_until_changed(table, screen.click))
            if control:
                screen.control(0)
            time.sleep(0.5)
        report(what, times)


def measure_drag(log, seconds=5):
    screen.move(*VIEW)
    screen.button(1)
    start = time.perf_counter()
    step = 0
    while time.perf_counter() - start < seconds:
        step += 1
        angle = 0.01 * step
        screen.move(VIEW[0] + int(100 * np.sin(angle)), VIEW[1] + int(60 * np.sin(0.7 * angle)))
        time.sleep(0.01)
    screen.button(0)
    time.sleep(2)
    with open(log, encoding="utf-8") as file:
        events = [(name, moment) for name, moment in json.load(file) if start < moment < start + seconds]
    spent = {"solve": 0.0, "draw": 0.0}
    begun = {}
    for name, moment in events:
        if name in spent:
            begun[name] = moment
        else:
            ended = {"solved": "solve", "drawn": "draw"}[name]
            if ended in begun:
                spent[ended] += moment - begun.pop(ended)
    updates = sum(name == "solved" for name, _ in events)
    # The view updates the filter as a part of its drawing.
    drawing = spent["draw"] - spent["solve"]
    print(f"Drag with live update: {updates / seconds:.1f} updates a second; of {1000 * seconds / updates:.0f} ms each, "
          f"{1000 * spent['solve'] / updates:.0f} ms are the filter's and {1000 * drawing / updates:.0f} ms the view's")


random.seed(1)
screen = Screen()
with tempfile.TemporaryDirectory() as folder:
    paraview, _ = start(1_000_000, 0, folder)
    print("1M triangles")
    measure_picks()
    paraview.kill()
    paraview.wait()
if not URL:
    with tempfile.TemporaryDirectory() as folder:
        paraview, log = start(320_000, 1, folder)
        print("160k points")
        measure_drag(log)
        paraview.kill()
        paraview.wait()
