# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts a .vtp of triangles (inline, zlib, 32-bit headers) to OFF, with Python's own library only.

Core is tested without VTK, so it can't read the test data itself.
usage: vtp_to_off.py input.vtp output.off
"""

import base64
import struct
import sys
import xml.etree.ElementTree
import zlib


def decoded(text):
    """Decodes one array: a header of block counts and sizes, then the compressed blocks."""
    (blocks,) = struct.unpack_from("<I", base64.b64decode(text[:8]))
    header_length = -(-(12 + 4 * blocks) // 3) * 4
    sizes = struct.unpack_from(f"<{blocks}I", base64.b64decode(text[:header_length]), 12)
    compressed = base64.b64decode(text[header_length:])
    data, position = b"", 0
    for size in sizes:
        data += zlib.decompress(compressed[position:position + size])
        position += size
    return data


def main(source, target):
    piece = xml.etree.ElementTree.parse(source).find("PolyData/Piece")

    def array(section, name):
        element = piece.find(f"{section}/DataArray[@Name='{name}']")
        code = {"Float32": "f", "Int64": "q"}[element.get("type")]
        data = decoded(element.text.strip())
        return struct.unpack(f"<{len(data) // struct.calcsize(code)}{code}", data)

    points = array("Points", "Points")
    corners = array("Polys", "connectivity")
    with open(target, "w") as out:
        print("OFF", len(points) // 3, len(corners) // 3, 0, file=out)
        for i in range(0, len(points), 3):
            print(*map(repr, points[i:i + 3]), file=out)
        for i in range(0, len(corners), 3):
            print(3, *corners[i:i + 3], file=out)


if __name__ == "__main__":
    main(*sys.argv[1:])
