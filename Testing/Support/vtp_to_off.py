"""Converts a .vtp of triangles (appended, raw, zlib) to OFF, with Python's own library only.

Core is tested without VTK, so it can't read the test data itself.
usage: vtp_to_off.py input.vtp output.off
"""

import re
import struct
import sys
import zlib


def appended_array(appended, offset):
    """Decodes one array: a header of block counts and sizes, then the compressed blocks."""
    (blocks,) = struct.unpack_from("<I", appended, offset)
    sizes = struct.unpack_from(f"<{blocks}I", appended, offset + 12)
    data, position = b"", offset + 12 + 4 * blocks
    for size in sizes:
        data += zlib.decompress(appended[position:position + size])
        position += size
    return data


def main(source, target):
    text = open(source, "rb").read()
    start = text.index(b"<AppendedData")
    appended = text[text.index(b"_", start) + 1:]
    header = text[:start].decode()

    def array(section, name):
        body = re.search(f"<{section}>(.*?)</{section}>", header, re.S).group(1)
        tag = re.search(f'<DataArray[^>]*Name="{name}"[^>]*>', body, re.S).group(0)
        kind = re.search(r'type="(\w+)"', tag).group(1)
        offset = int(re.search(r'offset="(\d+)"', tag).group(1))
        code, size = {"Float32": ("f", 4), "Int64": ("q", 8)}[kind]
        data = appended_array(appended, offset)
        return struct.unpack(f"<{len(data) // size}{code}", data)

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
