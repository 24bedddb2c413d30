# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that includes go one way: each layer, and each of its folders, sees only those before it.

usage: includes.py PROJECT_FOLDER
Prints each include that points the other way, and ends with status 1 where there is one.
"""

import os
import re
import sys

# The folders of these layers, each of which sees only those before it.
FOLDERS = {
    "Filters/Core": ["base", "mesh", "search", "solve", "threads", "march", "sources", "windows", "methods", "survey", "path", "split"],
    "Filters/Bridge": ["filter", "input", "request", "output"],
    "Filters/Distributed": ["ranks", "pieces", "global", "gather", "algorithm", "lines"],
}
# What the files of a layer may include beside the layer's own.
LAYERS = {
    "Filters/Bridge": ["Filters/Core"],
    "Filters/Distributed": ["Filters/Core", "Filters/Bridge"],
    "Filters/Geodesics": ["Filters/Core", "Filters/Bridge"],
    "Filters/Surface": ["Filters/Core", "Filters/Bridge", "Filters/Distributed"],
    "Widgets/Tracing": ["Filters/Core", "Filters/Bridge", "Filters/Geodesics"],
    "Widgets/Seeds": [],
    "Widgets/Fields": [],
    "Widgets/Lines": [],
}
INCLUDE = re.compile(r'^\s*#\s*include "([^"]+)"', re.MULTILINE)


def sources(folder):
    for place, _, files in os.walk(folder):
        for file in sorted(files):
            if file.endswith((".h", ".cxx")):
                yield os.path.join(place, file)


def included_by(file):
    with open(file) as stream:
        return INCLUDE.findall(stream.read())


def wrong_in_folders(project, layer, folders):
    place = os.path.join(project, layer)
    for file in sources(place):
        folder = os.path.relpath(file, place).split(os.sep)[0]
        if folder not in folders:
            yield file, f"lies in no folder of {layer}: {', '.join(folders)}"
            continue
        for header in included_by(file):
            other = header.split("/")[0]
            if other in folders and folders.index(other) > folders.index(folder):
                yield file, f'includes "{header}", but {folder} comes before {other}'


def wrong_in_layers(project):
    headers = {layer: {} for layer in [*LAYERS, "Filters/Core"]}
    for layer, names in headers.items():
        place = os.path.join(project, layer)
        for file in sources(place):
            names[os.path.relpath(file, place)] = file
    for layer, below in {"Filters/Core": [], **LAYERS}.items():
        for file in sources(os.path.join(project, layer)):
            for header in included_by(file):
                homes = [other for other, names in headers.items() if header in names]
                if not homes and layer in FOLDERS and not header.startswith("vtk"):
                    yield file, f'includes "{header}", which no layer has; name it with its folder'
                if homes and layer not in homes and not set(homes) & set(below):
                    yield file, f'includes "{header}" of {homes[0]}'


def main(project):
    wrong = [*wrong_in_layers(project)]
    for layer, folders in FOLDERS.items():
        wrong += wrong_in_folders(project, layer, folders)
    for file, why in wrong:
        print(f"{os.path.relpath(file, project)} {why}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main(sys.argv[1])
