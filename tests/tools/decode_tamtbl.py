#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a .TAMtbl file of the layout `generic` (docs/profiles.md) without any of the project's code
and prints it as JSON: tests and people compare it with what the programs say."""
import json
import struct
import sys
import zlib

file = open(sys.argv[1], "rb").read()
header, elements = file[:128], file[128:]
(magic, version, header_size, element_type, persistent, dimensions, *size) = struct.unpack(
    "<4sHHIII3I", header[:32])
start, distance = struct.unpack("<3d", header[32:56]), struct.unpack("<3d", header[56:80])
count, element_crc, name, reserved, header_crc = struct.unpack("<II32sII", header[80:])
values = struct.unpack(f"<{count}f", elements)
checks = {
    "magic": magic == b"TAMT" and version == 1 and header_size == 128 and element_type == 1,
    "size": size[0] * size[1] * size[2] == count,
    "elementCrc": zlib.crc32(elements) == element_crc,
    "headerCrc": zlib.crc32(header[:12] + bytes(4) + header[16:124]) == header_crc,
}
print(json.dumps({
    "name": name.rstrip(b"\0").decode(), "persistent": bool(persistent), "elements": count,
    "crc": f"{element_crc:08x}",
    "axes": [{"size": size[i], "start": start[i], "distance": distance[i]}
             for i in range(dimensions)],
    "values": values, "wrong": [check for check, holds in checks.items() if not holds]}))
sys.exit(0 if all(checks.values()) else 1)
