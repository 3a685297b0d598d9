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


def unfiltered(kind, row, above, step):
    """A row of a PNG without its filter (PNG specification, section 9)."""
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        up = above[i]
        corner = above[i - step] if i >= step else 0
        if kind == 4:
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda candidate: abs(guess - candidate))
        row[i] = (value + (0, left, up, (left + up) // 2, paeth if kind == 4 else 0)[kind]) & 255
    return row


def read_png(path):
    """(width, height, bytes of RGB) of a picture of 8 bits a channel that is not interlaced."""
    data, at, packed = pathlib.Path(path).read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", data[at + 8:at + 18])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    if depth != 8 or color not in (2, 6):
        raise ValueError(f"{path}: expected a PNG of RGB or RGBA of 8 bits")
    step, rows, pixels = 3 if color == 2 else 4, zlib.decompress(packed), bytearray()
    above = bytes(step * width)
    for y in range(height):
        start = y * (step * width + 1)
        above = unfiltered(rows[start], bytearray(rows[start + 1:start + 1 + step * width]), above, step)
        pixels += above if step == 3 else b"".join(above[i:i + 3] for i in range(0, len(above), 4))
    return width, height, bytes(pixels)


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
