# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""All scripts of a page of the guide run word for word, one after the other, and none of their filters has an error.

usage: Scripts.py PAGE DATA FOLDER SurfaceGeodesics.so      (in pvpython with the plugin loaded, or in python3)

FOLDER gets copies of the data, and the scripts run there. In the scripts /path/to/SurfaceGeodesics.so stands for the plugin.
"""

import os
import re
import shutil
import sys

page, data, folder, plugin = sys.argv[1:]
with open(page, encoding="utf-8") as text:
    scripts = re.findall(r"^```python\n(.*?)^```$", text.read(), re.MULTILINE | re.DOTALL)
assert scripts, f"{page} has no script"

shutil.rmtree(folder, ignore_errors=True)
shutil.copytree(data, folder)
os.chdir(folder)
names = {}
for script in scripts:
    print(script, flush=True)
    exec(compile(script.replace("/path/to/SurfaceGeodesics.so", plugin), page, "exec"), names)

for name, proxy in names.items():
    if hasattr(proxy, "ErrorText"):
        proxy.UpdatePipeline()
        proxy.UpdatePropertyInformation()
        assert not proxy.ErrorText, (name, proxy.ErrorText)
