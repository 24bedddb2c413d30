# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's playback cannot do, by a real pointer and real keys: P and Ctrl+P in the view, Esc, Ctrl+Z, Delete, copying and
pasting in the table, dragging a row of it, and typing a point after the Tab key.

usage: RealInput.py PARAVIEW FOLDER
"""

import sys
import time

import numpy as np

from pointer import ORANGE, Window, screen, settle, xdotool


def chosen_row():
    """The middle of the table's chosen row, and its height."""
    settle()
    chosen = np.array([48, 140, 198])
    y, x = np.nonzero((abs(screen()[560:] - chosen) < 3).all(axis=2))
    y += 560
    top, bottom = y.min(), y.max()
    return (x.min() + x.max()) // 2, (top + bottom) // 2, bottom - top + 2


window = Window(*sys.argv[1:], "Ball.py", ORANGE)
points, wait_for, wait_until = window.points, window.wait_for, window.wait_until
BUTTON, VIEW = window.button, window.view

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

window.close()
