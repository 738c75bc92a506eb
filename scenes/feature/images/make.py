#!/usr/bin/env python3
"""Makes the pictures that the scenes use: sky.exr (latitude-longitude, half, ZIPS) and tiles.png.

Python's standard library alone; the result is committed, so that nobody needs to run it.
"""
import math
import os
import struct
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))


def sky(u, v):
    """Radiance at u (0 to 1 from left to right, the middle is +z) and v (0 at the zenith)."""
    elevation = math.pi * (0.5 - v)
    azimuth = 2 * math.pi * (u - 0.5)
    d = (math.cos(elevation) * math.sin(azimuth), math.sin(elevation),
         math.cos(elevation) * math.cos(azimuth))
    sun = (0.48, 0.6, 0.64)
    cosine = sum(a * b for a, b in zip(d, sun))
    if d[1] >= 0:
        haze = (1 - d[1]) ** 5
        base = [0.16 + 0.75 * haze, 0.32 + 0.62 * haze, 0.75 + 0.25 * haze]
        glow = 0.6 * max(cosine, 0) ** 40 + 60 * max(cosine, 0) ** 3000
        return [b + glow * s for b, s in zip(base, (1.0, 0.9, 0.7))]
    # A sandy plain with lines to the horizon, so that reflections can be read.
    scale = 1 / max(-d[1], 0.02)
    x, z = d[0] * scale, d[2] * scale
    tile = (math.floor(x * 0.8) + math.floor(z * 0.8)) % 2
    fade = min(1.0, scale / 30)
    near = [0.5, 0.42, 0.3] if tile else [0.3, 0.25, 0.2]
    return [(1 - fade) * n + fade * h for n, h in zip(near, (0.7, 0.66, 0.6))]


def exr_attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data


def zip_block(raw):
    """OpenEXR's ZIP: bytes split into even and odd halves, differences, deflate."""
    halves = raw[0::2] + raw[1::2]
    deltas = bytes([halves[0]]) + bytes(
        (halves[i] - halves[i - 1] + 128) & 255 for i in range(1, len(halves)))
    packed = zlib.compress(deltas, 9)
    return packed if len(packed) < len(raw) else raw


def write_exr(path, width, height, pixel):
    channels = b"".join(c + b"\0" + struct.pack("<iB3xii", 1, 0, 1, 1) for c in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2)
    header += exr_attribute("channels", "chlist", channels)
    header += exr_attribute("chromaticities", "chromaticities",
                            struct.pack("<8f", 0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32168, 0.33767))
    header += exr_attribute("compression", "compression", bytes([2]))
    header += exr_attribute("dataWindow", "box2i", window)
    header += exr_attribute("displayWindow", "box2i", window)
    header += exr_attribute("lineOrder", "lineOrder", bytes([0]))
    header += exr_attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += exr_attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0))
    header += exr_attribute("screenWindowWidth", "float", struct.pack("<f", 1))
    header += b"\0"
    blocks, offset, offsets = [], len(header) + 8 * height, []
    for y in range(height):
        row = [pixel((x + 0.5) / width, (y + 0.5) / height) for x in range(width)]
        raw = b"".join(struct.pack("<%de" % width, *(p[c] for p in row)) for c in (2, 1, 0))
        packed = zip_block(raw)
        block = struct.pack("<ii", y, len(packed)) + packed
        offsets.append(offset)
        offset += len(block)
        blocks.append(block)
    with open(path, "wb") as out:
        out.write(header + struct.pack("<%dQ" % height, *offsets) + b"".join(blocks))


def tile(u, v):
    """A glazed tile: a blue star in rings on white, repeated twice each way."""
    x, y = (2 * u) % 1 - 0.5, (2 * v) % 1 - 0.5
    radius, angle = math.hypot(x, y), math.atan2(y, x)
    petal = 0.28 + 0.12 * math.cos(8 * angle)
    if max(abs(x), abs(y)) > 0.485:
        return (150, 146, 140)
    if radius < 0.07:
        return (214, 160, 48)
    if radius < petal * 0.8:
        return (32, 70, 150)
    if radius < petal:
        return (120, 165, 215)
    if 0.44 < radius < 0.47:
        return (32, 70, 150)
    if math.hypot(abs(x) - 0.5, abs(y) - 0.5) < 0.14:
        return (200, 90, 60)
    return (240, 238, 230)


def write_png(path, size, pixel):
    raw = b"".join(
        b"\0" + b"".join(bytes(pixel((x + 0.5) / size, (y + 0.5) / size)) for x in range(size))
        for y in range(size))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data) & 0xFFFFFFFF))

    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)) +
                  chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    write_exr(os.path.join(HERE, "sky.exr"), 1024, 512, sky)
    write_png(os.path.join(HERE, "tiles.png"), 512, tile)
