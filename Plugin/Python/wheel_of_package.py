# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the package surfacegeodesics and packs it as a wheel, for pip (PEP 517).

The wheel works with the Python that runs this and with the VTK that CMake finds. Arguments for CMake come from the environment
variable CMAKE_ARGS, for example CMAKE_ARGS=-DVTK_DIR=FOLDER. With --config-settings=build-dir=FOLDER, what is compiled stays there for
the next time.
"""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
METADATA = """\
Metadata-Version: 2.1
Name: surfacegeodesics
Version: {version}
Summary: Geodesic distances and paths on surfaces, for VTK
License: BSD-3-Clause
Requires-Dist: numpy
"""
WHEEL = """\
Wheel-Version: 1.0
Generator: wheel_of_package
Root-Is-Purelib: false
Tag: {tag}
"""


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """The hook that pip calls. Returns the name of the file in wheel_directory."""
    version = re.search(r"^  VERSION (\S+)$", (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)[1]
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    with tempfile.TemporaryDirectory() as folder:
        build = (config_settings or {}).get("build-dir", f"{folder}/build")
        contents = _contents(pathlib.Path(build), pathlib.Path(folder) / "prefix")
    information = f"surfacegeodesics-{version}.dist-info"
    contents[f"{information}/METADATA"] = METADATA.format(version=version).encode()
    contents[f"{information}/WHEEL"] = WHEEL.format(tag=tag).encode()
    contents[f"{information}/LICENSE"] = (PROJECT / "LICENSE").read_bytes()
    record = f"{information}/RECORD"
    contents[record] = "".join([*map(_line_of_record, contents.items()), f"{record},,\n"]).encode()
    name = f"surfacegeodesics-{version}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in contents.items():
            wheel.writestr(path, content)
    return name


def _contents(build, prefix):
    """{path in the wheel: content} of the package, built in one folder and installed in the other."""
    _run("cmake", "-S", PROJECT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
         "-DSURFACEGEODESICS_BUILD_PLUGIN=OFF", "-DSURFACEGEODESICS_BUILD_VTK=ON",
         # All in one folder, so that modules and libraries find each other wherever the wheel is installed.
         "-DCMAKE_INSTALL_LIBDIR=surfacegeodesics", "-DSURFACEGEODESICS_PYTHON_DESTINATION=.",
         "-DCMAKE_INSTALL_RPATH_USE_LINK_PATH=ON", f"-DPython3_EXECUTABLE={sys.executable}",
         *shlex.split(os.environ.get("CMAKE_ARGS", "")))
    _run("cmake", "--build", build)
    _run("cmake", "--install", build, "--prefix", prefix, "--strip")
    package = prefix / "surfacegeodesics"
    files = [file for file in sorted(package.iterdir()) if file.suffix in (".py", ".typed") or _is_loaded(file)]
    return {f"surfacegeodesics/{file.name}": file.read_bytes() for file in files}


def _is_loaded(file):
    """Whether Python or the loader looks for a library by this name; a wheel has no symbolic links."""
    if ".so" not in file.suffixes:
        return False
    names = subprocess.run(["readelf", "-d", file], check=True, capture_output=True, text=True).stdout
    found = re.search(r"\(SONAME\).*\[(.*)\]", names)
    return not found or found[1] == file.name


def _line_of_record(entry):
    path, content = entry
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{path},sha256={digest},{len(content)}\n"


def _run(*command):
    subprocess.run(command, check=True)
