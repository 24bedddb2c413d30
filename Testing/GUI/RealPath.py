# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A path on a plane by a real pointer and real keys: a waypoint inserted by a click on the path, one added beside
it, one dragged, one removed, and what was done taken back. The path is seen as a solid line.

usage: RealPath.py PARAVIEW FOLDER
"""

import sys
import time

import numpy as np

from pointer import TEAL, Window, places_of, settle, xdotool

MAGENTA = (217, 0, 217)

window = Window(*sys.argv[1:], "ShownPath.py", TEAL)


def pixels_of_unit():
    """By the markers of the outer waypoints, which are 0.8 from each other."""
    x, _ = places_of(TEAL)
    in_view = x[x > window.button[0] + 200]
    is_left = in_view < window.view[0]
    return (in_view[~is_left].mean() - in_view[is_left].mean()) / 0.8


PIXELS = pixels_of_unit()


def place(x, y):
    """Where the view shows a point of the plane."""
    return round(window.view[0] + x * PIXELS), round(window.view[1] - y * PIXELS)


def rows_of_path():
    """How many rows of pixels the first segment takes between its waypoints, column by column."""
    (left, row), (right, _) = place(-0.3, -0.3), place(-0.1, -0.3)
    x, y = places_of(MAGENTA)
    beside = abs(y - row) < 12
    return np.bincount(x[beside], minlength=right)[left:right]


window.wait_until("the path to be seen", lambda: rows_of_path().min() >= 3)

# A click on the first segment inserts a waypoint, exactly on it.
xdotool("mousemove", *window.button, "click", 1)
before = window.points()
xdotool("mousemove", *place(0, -0.3))
settle()
window.take_picture("insert")
xdotool("click", 1)
window.wait_for(4)
found = window.points()
assert np.array_equal(found[[0, 2, 3]], before), found
assert abs(found[1, 0]) < 5e-3 and abs(found[1, 1] + 0.3) < 1e-7, found

# Beside it a click adds one at the end.
xdotool("mousemove", *place(-0.2, 0.2), "click", 1)
window.wait_for(5)
assert np.allclose(window.points()[4], [-0.2, 0.2, 0], atol=5e-3), window.points()

# The inserted one is dragged.
settle()
xdotool("key", "Escape", "mousemove", *place(0, -0.3), "mousedown", 1)
for step in range(1, 11):
    xdotool("mousemove", *place(0, -0.3 + 0.02 * step))
    time.sleep(0.05)
window.take_picture("drag")
xdotool("mouseup", 1)
window.wait_until("the waypoint to be moved", lambda: np.allclose(window.points()[1], [0, -0.1, 0], atol=5e-3))

# A click chooses it, Delete removes it, and that is taken back.
settle()
moved = window.points()
xdotool("mousemove", *place(0, -0.1), "click", 1, "key", "Delete")
window.wait_for(4)
xdotool("key", "ctrl+z")
window.wait_for(5)
assert np.array_equal(window.points(), moved), window.points()

# Applied, all of it is seen.
xdotool("key", "alt+a")
settle()
window.take_picture("applied")
window.close()
