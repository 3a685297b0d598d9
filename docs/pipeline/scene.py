"""What ffgpu says of the tour's scene: pictures, figures, and the history of single pixels."""

import csv
import functools
import json
import re
import subprocess

import canvas

FRAME = 1  # the second: textures are there, pages are touched
NUMBER = r"-?[0-9][0-9.e+-]*"


class Scene:
    def __init__(self, ffgpu, trace, folder):
        self.ffgpu, self.trace, self.folder = ffgpu, trace, folder
        self.run("replay", trace, "-o", folder / "one", "--timing", "--per-draw", "--steps", "1", "--frames",
                 FRAME, "--view", "wireframe,depth,stencil,normals,texcoord,unlit,untextured,before-fog",
                 "--heatmap", "covered,depth_killed,alpha_killed,level,texture_misses", "--heatmap-scale", 5)
        self.run("replay", trace, "-o", folder / "four", "--timing", "--frames", FRAME, "--samples", 4)
        self.frame = self.figures("one")
        self.multisampled = self.figures("four")

    def run(self, *arguments):
        return subprocess.run([str(part) for part in (self.ffgpu, *arguments)], check=True, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout

    def figures(self, run):
        """Functional counters and those of the machine in time, under their names."""
        statistics = json.loads((self.folder / run / "stats.json").read_text())
        [frame], self.machine = statistics["frames"], statistics["configuration"]
        return {**frame["functional"], **frame["timing"], "milliseconds": frame["milliseconds"],
                "histograms": frame["histograms"], "commands": frame["commands"], "pixels": frame["pixels"]}

    def draws(self):
        """The lines of draws.csv that are draws, by column."""
        with (self.folder / "one" / "draws.csv").open(newline="") as file:
            return [line for line in csv.DictReader(file) if line["kind"] == "draw"]

    def picture(self, name, run="one"):
        return canvas.Canvas.read(self.folder / run / f"{name}_{FRAME:04}.png")

    @property
    def first_draw(self):
        """The number of the frame's first draw, as pictures of single draws have it."""
        paths = (self.folder / "one").glob("frame_*_draw_*.png")
        return min(int(path.stem.split("_")[-1]) for path in paths)

    def step(self, draw):
        """The frame as it is behind a draw of it, the first being 0."""
        name = f"frame_{FRAME:04}_draw_{self.first_draw + draw:04}.png"
        return canvas.Canvas.read(self.folder / "one" / name)

    @functools.cache
    def explained(self, x, y):
        """The history of a pixel."""
        return self.run("explain", self.trace, "--frame", FRAME, "--pixel", f"{x},{y}")

    def footprint(self, x, y):
        path = self.folder / "footprint.png"
        self.run("explain", self.trace, "--frame", FRAME, "--pixel", f"{x},{y}", "--footprint", path)
        return canvas.Canvas.read(path)

    @functools.cache
    def region(self, x, y, width, height):
        """The text of each pixel's history, rows from the top."""
        path = self.folder / "region.html"
        self.run("explain", self.trace, "--frame", FRAME, "--explain-region", f"{x},{y},{width},{height}",
                 "-o", path)
        data = json.loads(re.search(r'id="data">(.*?)</script>', path.read_text(), re.S)[1])
        texts = ["\n".join(data["lines"][i] for i in pixel) for pixel in data["pixels"]]
        return [texts[row * width:(row + 1) * width] for row in range(height)]


def fragments(text):
    """The paragraphs of a history that tell of fragments, as (draw of the program, primitive, text)."""
    found = []
    for paragraph in text.split("\n\n"):
        head = re.match(r"\d+\. fragment.* draw (\d+), primitive (\d+), piece (\d+)", paragraph)
        if head:
            found.append((*map(int, head.groups()), paragraph))
    return found


def numbers(paragraph, pattern):
    """The numbers on the line that begins with the pattern."""
    line = re.search(rf"^ *{pattern}(.*)$", paragraph, re.M)
    return [float(n) for n in re.findall(NUMBER, line[1])] if line else []
