# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window on an X server, as a user has it: events are given to the server, and pixels are read from it."""

import ctypes
import os
import subprocess
import sys
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
WIDTH, HEIGHT = 1366, 768
# The middle of the view.
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


def start(paraview, script, folder, arguments=(), **environment):
    """Starts ParaView in a window as large as the screen, with settings of its own; returns the process."""
    os.makedirs(os.path.join(folder, "ParaView"))
    version = subprocess.run([paraview, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.split()[-1]
    # The file has the version in its name up to 5.13.
    for name in f"ParaView{version}.ini", "ParaView.ini":
        with open(os.path.join(folder, "ParaView", name), "w", encoding="utf-8") as file:
            file.write(SETTINGS)
    return subprocess.Popen(
        [paraview, *arguments, "-qwindowgeometry", f"{WIDTH}x{HEIGHT}+0+0", f"--script={os.path.join(HERE, script)}"],
        env={**os.environ, **environment, "XDG_CONFIG_HOME": folder},
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
