# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""How long a user waits for the SurfaceSeeds widget, measured from outside: an event is given to the X server, and the
time counts until the pixels change.

usage: xvfb-run -a -s "-screen 0 1366x768x24" python3 PickingBenchmark.py PARAVIEW [URL]

Needs PV_PLUGIN_CONFIG_FILE. With the URL of a ParaView server, that one has the data and draws them.
Prints, in ms, on 1M triangles and with a still camera: the marker that follows the pointer, and a seed's row in the
table after a click and after Ctrl+click.
"""

import os
import random
import sys
import tempfile
import time

import numpy as np

from Window import VIEW, Screen, start

PARAVIEW, *URL = sys.argv[1:]
ORANGE = (230, 76, 26)


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


random.seed(1)
screen = Screen()
with tempfile.TemporaryDirectory() as folder:
    log = os.path.join(folder, "shown")
    paraview = start(PARAVIEW, "PickingInside.py", folder, [f"--url={url}" for url in URL], SHOWN=log)
    while not os.path.exists(log) or len(screen.places_of(ORANGE)[0]) < 20:
        time.sleep(0.1)
    time.sleep(3)
    measure_picks()
    paraview.kill()
    paraview.wait()
