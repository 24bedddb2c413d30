# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's playback cannot do, by a real pointer and real keys: P and Ctrl+P in the view, Esc, Ctrl+Z, Delete, copying and
pasting in the table, dragging a row of it, and typing a point after the Tab key.

usage: RealInput.py PARAVIEW FOLDER
"""

import json
import os
import subprocess
import sys
import time

import numpy as np

PARAVIEW, FOLDER = sys.argv[1:]
REPORT = os.path.join(FOLDER, "points.json")
WIDTH, HEIGHT = 1366, 768
# The colours of the markers and of the table's chosen row.
ORANGE = (230, 76, 26)
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


def points():
    with open(REPORT, encoding="utf-8") as file:
        return np.reshape(json.load(file), (-1, 3))


def wait_until(what, condition):
    """A minute is for a machine that does much else; the answer comes at once."""
    for _ in range(600):
        if condition():
            return
        assert paraview.poll() is None, "ParaView has ended"
        time.sleep(0.1)
    subprocess.run(["import", "-window", "root", os.path.join(FOLDER, "failed.png")], check=True)
    sys.exit(f"FAILED: {what}; see failed.png")


def wait_for(count):
    wait_until(f"{count} points", lambda: len(points()) == count)


def settle():
    """Waits until the screen stands still: the table grows with its rows."""
    before = None
    while before is None or not np.array_equal(before, screen()):
        before = screen()
        time.sleep(0.5)


def chosen_row():
    """The middle of the table's chosen row, and its height."""
    settle()
    chosen = np.array([48, 140, 198])
    y, x = np.nonzero((abs(screen()[560:] - chosen) < 3).all(axis=2))
    y += 560
    top, bottom = y.min(), y.max()
    return (x.min() + x.max()) // 2, (top + bottom) // 2, bottom - top + 2


if os.path.exists(REPORT):
    os.remove(REPORT)
paraview = subprocess.Popen(
    [PARAVIEW, "-qwindowgeometry", f"{WIDTH}x{HEIGHT}+0+0", "--dr",
     "--script=" + os.path.join(os.environ["PYTHONPATH"], "Reporting.py")],
    env={**os.environ, "REPORT": REPORT})
wait_until("ParaView to start", lambda: os.path.exists(REPORT))

# The button has the colour of the markers; the ball is in the middle of the view, which is green round it.
wait_until("the panel", lambda: len(places_of(ORANGE)[0]) > 20)
x, y = places_of(ORANGE)
BUTTON = int(x.mean()), int(y.mean())
wait_until("the view", lambda: len(places_of(GREEN)[0]) > 100000)
x, y = places_of(GREEN)
VIEW = (x.min() + x.max() + 1) // 2, (y.min() + y.max() + 1) // 2

# The keys go to the view once it has been clicked in.
xdotool("mousemove", VIEW[0] - 300, VIEW[1] - 200, "click", 1)
xdotool("mousemove", VIEW[0] + 20, VIEW[1] + 13, "key", "p")
wait_for(1)
assert 0.01 < points()[0, 0] < 0.1 and -0.1 < points()[0, 1] < -0.01, points()
# In the view Ctrl+Z takes back the pick, and Delete removes what is chosen, the last picked point.
xdotool("key", "ctrl+z")
wait_for(0)
xdotool("key", "p")
wait_for(1)
xdotool("key", "Delete")
wait_for(0)
xdotool("key", "p")
wait_for(1)
xdotool("mousemove", VIEW[0] + 60, VIEW[1] - 40, "key", "ctrl+p")
wait_for(2)
# The ball's points are turned by a 32nd of a circle from meridian to meridian.
turns = np.degrees(np.arctan2(points()[:, 1], points()[:, 0])) / (360 / 32)
assert abs(turns[1] - round(turns[1])) < 1e-4 < abs(turns[0] - round(turns[0])), turns

# With the button pressed a click adds, until Esc.
xdotool("mousemove", *BUTTON, "click", 1)
xdotool("mousemove", VIEW[0] - 40, VIEW[1] - 40, "click", 1)
wait_for(3)
xdotool("key", "Escape")
xdotool("mousemove", VIEW[0] + 40, VIEW[1] + 60, "click", 1)
xdotool("mousemove", VIEW[0] + 50, VIEW[1] + 60, "key", "p")
wait_for(4)
three = points()[:3]
assert points()[3, 0] > 0.06, "The click after Esc was taken as well"

# The last row is chosen: copied and pasted it is there twice, and the new one is chosen.
table, row, height = chosen_row()
xdotool("mousemove", table, row, "click", 1, "key", "ctrl+c", "key", "ctrl+v")
wait_for(5)
assert np.array_equal(points()[4], points()[3]), points()
xdotool("key", "Delete")
wait_for(4)
settle()

# The last row is dragged before the one above it.
before = points()
xdotool("mousemove", table, row, "click", 1)
settle()
xdotool("mousedown", 1)
for step in range(1, 11):
    xdotool("mousemove", table + step, int(row - step * (1.4 * height) / 10))
    time.sleep(0.05)
xdotool("mouseup", 1)
wait_until("the row to be moved", lambda: not np.array_equal(points(), before))
assert np.array_equal(points(), before[[0, 1, 3, 2]]), (before, points())

# From the table the Tab key leads to the buttons: one row more, typed without the mouse.
xdotool("key", "Tab", "space")
wait_for(5)
xdotool("type", "--delay", "50", "0.1")
xdotool("key", "Tab")
xdotool("type", "--delay", "50", "0.2")
xdotool("key", "Tab")
xdotool("type", "--delay", "50", "0.3")
xdotool("key", "Return")
wait_until("the typed point", lambda: np.allclose(points()[4], [0.1, 0.2, 0.3]))

paraview.kill()
paraview.wait()
