# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script draws its picture, and it looks like the one in the guide.

usage: pvpython Picture.py SCRIPT DATA PICTURE NEW

Other versions of ParaView draw other fonts, backgrounds and shades. So cells may differ on average by less than a tenth of the range.
An empty view or another surface differs by more.
"""

import os
import runpy
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from likeness import differences

script, data, picture, new = sys.argv[1:]
sys.argv = [script, data, new]
runpy.run_path(script, run_name="__main__")
difference = differences(picture, new).mean()
print(f"Mean difference of cells: {difference:.4f}")
assert difference < 0.1, difference
