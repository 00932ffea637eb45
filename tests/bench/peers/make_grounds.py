#!/usr/bin/env python3
"""Writes the grounds of bench_rover.rover that are files: assets/terrains/bench_sinus.png and bench_rough.png.

Heights at points 10 mm apart, x from -1 to 5 m, y from -0.8 to 0.8 m, as grey levels of 2.5 um. Both are pure
functions of x and y, level for x < 0.6 m. Usage, from anywhere: tests/bench/peers/make_grounds.py
"""

import math
import pathlib
import struct
import zlib

CELL = 0.01
COLUMNS, ROWS = 601, 161
X0, Y0 = -1.0, -0.8
LEVEL = 2.5e-6  # [m]; the whole range, 65535 levels, is 0.1638375 m


def sinus(x, y):
    """Waves of 0.1 m from crest to trough, 0.8 m long."""
    return 0.0 if x < 0.6 else 0.05 * (1.0 - math.cos(2.0 * math.pi * (x - 0.6) / 0.8))


def lattice(i, j, seed):
    """0 to 1 from two integers: a hash of 32 bit, the same on every machine."""
    h = (seed * 0x9E3779B9 + i * 0x85EBCA6B + j * 0xC2B2AE35) & 0xFFFFFFFF
    h = (h ^ h >> 16) * 0x7FEB352D & 0xFFFFFFFF
    h = (h ^ h >> 15) * 0x846CA68B & 0xFFFFFFFF
    return (h ^ h >> 16) / 0xFFFFFFFF


def smooth(t):
    return t * t * (3.0 - 2.0 * t)


def noise(x, y, seed):
    """Value noise: lattice values, smoothly interpolated."""
    i, j = math.floor(x), math.floor(y)
    u, v = smooth(x - i), smooth(y - j)
    near = lattice(i, j, seed) * (1.0 - u) + lattice(i + 1, j, seed) * u
    far = lattice(i, j + 1, seed) * (1.0 - u) + lattice(i + 1, j + 1, seed) * u
    return near * (1.0 - v) + far * v


def rough(x, y):
    """Three octaves of value noise that grow out of level ground between 0.6 and 0.9 m."""
    share = smooth(min(max((x - 0.6) / 0.3, 0.0), 1.0))
    if share == 0.0:
        return 0.0
    return share * (0.10 * noise(x / 0.40, y / 0.40, 1) + 0.04 * noise(x / 0.17, y / 0.17, 2)
                    + 0.01 * noise(x / 0.06, y / 0.06, 3))


def levels(height):
    """Rows from the largest y to the smallest, as pictures have them."""
    return [[round(height(X0 + column * CELL, Y0 + row * CELL) / LEVEL) for column in range(COLUMNS)]
            for row in reversed(range(ROWS))]


def paeth(left, up, corner):
    """Predictor of the PNG specification, section 9.4."""
    estimate = left + up - corner
    return min((left, up, corner), key=lambda value: abs(estimate - value))


def filtered(row, above):
    """A row of bytes by the PNG filter that leaves the smallest differences."""
    step = 2  # bytes a pixel
    left = bytes(step) + row[:-step]
    corner = bytes(step) + above[:-step]
    choices = (row,
               bytes((r - a) & 0xFF for r, a in zip(row, left)),
               bytes((r - b) & 0xFF for r, b in zip(row, above)),
               bytes((r - (a + b) // 2) & 0xFF for r, a, b in zip(row, left, above)),
               bytes((r - paeth(a, b, c)) & 0xFF for r, a, b, c in zip(row, left, above, corner)))
    kind = min(range(5), key=lambda k: sum(min(d, 256 - d) for d in choices[k]))
    return bytes([kind]) + choices[kind]


def write_png(path, rows):
    """Grey, 16 bit."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    packed = [struct.pack(f">{len(row)}H", *row) for row in rows]
    body = b"".join(filtered(row, above) for row, above in zip(packed, [bytes(len(packed[0]))] + packed))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 16, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(body, 9))
                     + chunk(b"IEND", b""))


def main():
    folder = pathlib.Path(__file__).resolve().parents[3] / "assets/terrains"
    for name, height in (("bench_sinus.png", sinus), ("bench_rough.png", rough)):
        rows = levels(height)
        write_png(folder / name, rows)
        print(f"{name}: {(folder / name).stat().st_size} bytes, up to {max(map(max, rows)) * LEVEL:.4f} m")


if __name__ == "__main__":
    main()
