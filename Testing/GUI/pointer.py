# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window under a real pointer and real keys."""

import json
import os
import subprocess
import sys
import time

import numpy as np

WIDTH, HEIGHT = 1366, 768
# The colours of seeds and waypoints, and of the view's background.
ORANGE = (230, 76, 26)
TEAL = (0, 140, 89)
GREEN = (0, 255, 0)


def xdotool(*arguments):
    subprocess.run(["xdotool", *map(str, arguments)], check=True)


def screen():
    raw = subprocess.run(
        ["import", "-window", "root", "-depth", "8", "rgb:-"], stdout=subprocess.PIPE, check=True)
    return np.frombuffer(raw.stdout, np.uint8).reshape(HEIGHT, WIDTH, 3).astype(int)


def places_of(color):
    """x and y of the pixels of about this colour."""
    y, x = np.nonzero((abs(screen() - color) < 4).all(axis=2))
    return x, y


def settle():
    """Waits until the screen stands still: the table grows with its rows."""
    before = None
    while before is None or not np.array_equal(before, screen()):
        before = screen()
        time.sleep(0.5)


class Window:
    """
    ParaView after a script of this folder.

    color:  of the markers
    button: where the button Pick is on the screen
    view:   the middle of the view
    """

    def __init__(self, paraview, folder, setup, color):
        self.folder = folder
        self.report = os.path.join(folder, "points.json")
        if os.path.exists(self.report):
            os.remove(self.report)
        self.process = subprocess.Popen(
            [paraview, "-qwindowgeometry", f"{WIDTH}x{HEIGHT}+0+0", "--dr",
             "--script=" + os.path.join(os.environ["PYTHONPATH"], "Reporting.py")],
            env={**os.environ, "REPORT": self.report, "SETUP": setup})
        self.wait_until("ParaView to start", lambda: os.path.exists(self.report))
        # The button has the colour of the markers; the view is green round what it shows.
        self.wait_until("the panel", lambda: len(places_of(color)[0]) > 20)
        self.wait_until("the view", lambda: len(places_of(GREEN)[0]) > 50000)
        settle()
        x, y = places_of(GREEN)
        self.view = (x.min() + x.max() + 1) // 2, (y.min() + y.max() + 1) // 2
        x, y = places_of(color)
        in_panel = x < self.view[0] // 2
        self.button = int(x[in_panel].mean()), int(y[in_panel].mean())

    def points(self):
        """The points in the panel."""
        with open(self.report, encoding="utf-8") as file:
            return np.reshape(json.load(file), (-1, 3))

    def wait_until(self, what, condition):
        """A minute is for a machine that does much else; the answer comes at once."""
        for _ in range(600):
            if condition():
                return
            assert self.process.poll() is None, "ParaView has ended"
            time.sleep(0.1)
        self.take_picture("failed")
        sys.exit(f"FAILED: {what}; see failed.png")

    def wait_for(self, count):
        self.wait_until(f"{count} points", lambda: len(self.points()) == count)

    def take_picture(self, name):
        subprocess.run(["import", "-window", "root", os.path.join(self.folder, f"{name}.png")], check=True)

    def close(self):
        self.process.kill()
        self.process.wait()
