# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""The packages that cpack made have what they should, each file in one of them, and nothing that is not ours.

usage: python3 Packages.py FOLDER VERSION PARAVIEW_VERSION PROJECT
"""

import pathlib
import re
import subprocess
import sys
import tarfile

folder, version, paraview, project = sys.argv[1:]
plugins = f"lib/paraview-{paraview}/plugins"


def package(pattern):
    found = list(pathlib.Path(folder).glob(pattern))
    assert len(found) == 1, (pattern, found)
    return found[0]


def field(name, deb):
    return subprocess.run(["dpkg-deb", "-f", deb, name], check=True, capture_output=True, text=True).stdout.strip()


def files_of(deb):
    """{path below /usr: where it links to, None for a file}."""
    listing = subprocess.run(["dpkg-deb", "-c", deb], check=True, capture_output=True, text=True).stdout
    found = {}
    for line in listing.splitlines():
        kind, path = line[0], line.split(None, 5)[5]
        path, _, target = path.partition(" -> ")
        assert path.startswith("./usr/") or kind == "d", line
        if kind != "d":
            found[path.removeprefix("./usr/")] = target or None
    return found


EXPECTED = {
    "paraview-surfacegeodesics": [
        f"{plugins}/SurfaceGeodesics/SurfaceGeodesics.so", f"{plugins}/surfacegeodesics.plugins.xml",
        "bin/plugins/SurfaceGeodesics", "share/doc/paraview-surfacegeodesics/copyright",
        "share/doc/paraview-surfacegeodesics/guide/install.md", "share/doc/paraview-surfacegeodesics/CITATION.cff",
        "share/doc/paraview-surfacegeodesics/pictures/regions.png",
        "share/doc/paraview-surfacegeodesics/pictures/live-drag.gif",
        "share/doc/paraview-surfacegeodesics/Data/Bunny.vtp", "share/doc/paraview-surfacegeodesics/Data/README.md",
        "share/doc/paraview-surfacegeodesics/Examples/States/Path.py"],
    "python3-surfacegeodesics": [
        f"lib/python3/dist-packages/surfacegeodesics/{name}" for name in ("__init__.py", "measure.py", "py.typed")],
    "libsurfacegeodesics-dev": [
        "lib/cmake/SurfaceGeodesics/SurfaceGeodesicsConfig.cmake", "bin/GeodesicPathExample",
        "include/surfacegeodesics/vtkFastMarchingGeodesicPath.h"]}

owners = {}
for name, expected in EXPECTED.items():
    deb = package(f"{name}_{version}_*.deb")
    assert field("Version", deb) == version
    files = files_of(deb)
    for path in expected:
        assert path in files, (name, path, sorted(files))
    for path in files:
        assert path not in owners, f"{path} is in {owners[path]} and in {name}"
        owners[path] = name
assert any(re.fullmatch(r"lib/[^/]*libvtkFiltersSurfaceGeodesics.*\.so.*", path) for path in owners), sorted(owners)

plugin = package(f"paraview-surfacegeodesics_{version}_*.deb")
assert f"paraview (>= {paraview})" in field("Depends", plugin)
assert f"paraview-surfacegeodesics (= {version})" in field("Depends", package(f"python3-surfacegeodesics_{version}_*.deb"))
# The link by which ParaView loads the plugin leads to it.
link = files_of(plugin)["bin/plugins/SurfaceGeodesics"]
assert pathlib.PurePosixPath("/usr/bin/plugins", link).parts.count("..") == 2, link
assert link == f"../../{plugins}/SurfaceGeodesics", link

with tarfile.open(package(f"surfacegeodesics-{version}-*.tar.gz")) as archive:
    names = {name.partition("/")[2] for name in archive.getnames()}
assert owners.keys() <= names, sorted(owners.keys() - names)

citation = (pathlib.Path(project) / "Plugin/Documentation/CITATION.cff").read_text(encoding="utf-8")
assert f"\nversion: {version}\n" in citation, citation
changes = (pathlib.Path(project) / "Plugin/Documentation/CHANGES.md").read_text(encoding="utf-8")
assert f"\n## {version}" in changes
