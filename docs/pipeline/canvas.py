"""Pictures put together: crops, magnified pixels, lines, panels beside each other. RGB, the top row first."""

import pathlib
import struct
import sys
import zlib

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "gallery"))
from pictures import chunk, read_png  # noqa: E402

WHITE, BLACK, GREY = (255, 255, 255), (0, 0, 0), (128, 128, 128)


class Canvas:
    def __init__(self, width, height, color=WHITE):
        self.width, self.height = width, height
        self.rows = [bytearray(bytes(color) * width) for _ in range(height)]

    @classmethod
    def read(cls, path):
        width, height, pixels = read_png(path)
        canvas = cls(width, height)
        canvas.rows = [bytearray(pixels[3 * width * y:3 * width * (y + 1)]) for y in range(height)]
        return canvas

    def put(self, x, y, color):
        if 0 <= x < self.width and 0 <= y < self.height:
            self.rows[y][3 * x:3 * x + 3] = bytes(color)

    def fill(self, x, y, width, height, color):
        left, right = max(x, 0), min(x + width, self.width)
        for row in self.rows[max(y, 0):min(y + height, self.height)]:
            row[3 * left:3 * right] = bytes(color) * max(right - left, 0)

    def line(self, begin, end, color):
        """From one point to another, whole steps along the longer axis."""
        steps = max(1, round(max(abs(end[0] - begin[0]), abs(end[1] - begin[1]))))
        for i in range(steps + 1):
            x, y = (b + (e - b) * i / steps for b, e in zip(begin, end))
            self.put(int(x), int(y), color)

    def outline(self, points, color):
        for begin, end in zip(points, points[1:] + points[:1]):
            self.line(begin, end, color)

    def crop(self, x, y, width, height):
        part = Canvas(width, height)
        part.rows = [row[3 * x:3 * (x + width)] for row in self.rows[y:y + height]]
        return part

    def magnified(self, factor):
        large = Canvas(self.width * factor, self.height * factor)
        for y, row in enumerate(self.rows):
            wide = b"".join(bytes(row[3 * x:3 * x + 3]) * factor for x in range(self.width))
            for i in range(factor):
                large.rows[y * factor + i] = bytearray(wide)
        return large

    def pixels(self):
        return b"".join(bytes(row) for row in self.rows)

    def png(self):
        """Rows without a filter: read back by slices alone."""
        rows = b"".join(b"\0" + bytes(row) for row in self.rows)
        size = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) + chunk(b"IDAT", zlib.compress(rows, 9)) +
                chunk(b"IEND", b""))


def beside(*panels, gap=8):
    """From left to right, with the tops in a line."""
    whole = Canvas(sum(p.width for p in panels) + gap * (len(panels) - 1), max(p.height for p in panels))
    x = 0
    for panel in panels:
        for y, row in enumerate(panel.rows):
            whole.rows[y][3 * x:3 * (x + panel.width)] = row
        x += panel.width + gap
    return whole


def grid(columns, rows, cell, color_of):
    """Magnified pixels with a seam between them: color_of(x, y)."""
    whole = Canvas(columns * cell, rows * cell, GREY)
    for y in range(rows):
        for x in range(columns):
            whole.fill(x * cell, y * cell, cell - 1, cell - 1, color_of(x, y))
    return whole
