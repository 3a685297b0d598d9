"""Pictures for the page: PPM in, PNG out, with nothing but Python's own library."""

import base64
import pathlib
import struct
import zlib

GAIN = 8  # how much the difference picture shows of a difference


def read_ppm(path):
    """(width, height, bytes of RGB)."""
    magic, size, depth, pixels = pathlib.Path(path).read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    if magic != b"P6" or depth != b"255" or len(pixels) != 3 * width * height:
        raise ValueError(f"{path}: expected a PPM of 8 bits")
    return width, height, pixels


def difference(a, b):
    """The sizes of all differences, times GAIN."""
    width, height, _ = a
    return width, height, bytes(min(255, GAIN * abs(x - y)) for x, y in zip(a[2], b[2]))


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(picture):
    """As a data: address."""
    width, height, pixels = picture
    rows = b"".join(b"\0" + pixels[3 * width * y:3 * width * (y + 1)] for y in range(height))
    data = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
    return "data:image/png;base64," + base64.b64encode(data).decode()
