"""What the tests of the sweep share: the program, a small space, and the table read back."""
import csv
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

FFGPU = os.environ["FFGPU_BINARY"]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
TRACE = SOURCE / "traces" / "corridor.trace"
FRAMES = ["--frames", "0-0"]

# Enumerated by hand below: 2 x 2 points, one of a list, and samples of one machine alone.
SPACE = """
[fixed]
texel_cache.line_bytes = 64
[grid]
texel_cache.sets = [16, 64]
texel_cache.ways = { from = 1, to = 2 }
[[list]]
texel_cache.sets = 8
raster.quads_per_cycle = 4
[random]
samples = 3
seed = 7
axes.raster.traversal = ["scanline"]
"""
# sets, ways (the default is 4), quads a cycle, traversal: in the order of the table.
POINTS = [("16", "1", "1", "tiled"), ("16", "2", "1", "tiled"), ("64", "1", "1", "tiled"),
          ("64", "2", "1", "tiled"), ("8", "4", "4", "tiled"), ("64", "4", "1", "scanline")]


class SweepCase(unittest.TestCase):
    def setUp(self):
        if not shutil.which("snakemake"):
            self.skipTest("snakemake is not installed")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ffgpu_sweep_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def command(self, output, *more, space=SPACE, traces=(TRACE,), frames=FRAMES):
        path = self.write("space_%s.toml" % hashlib.sha256(space.encode()).hexdigest()[:8], space)
        return [FFGPU, "sweep", str(path), *map(str, traces), "-o", str(self.folder / output),
                *frames, *more]

    def sweep(self, output, *more, **named):
        return subprocess.run(self.command(output, *more, **named), capture_output=True, text=True,
                              check=False)

    def swept(self, output, *more, **named):
        done = self.sweep(output, *more, **named)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.folder / output / "results.csv").read_bytes()

    def rows(self, output):
        with open(self.folder / output / "results.csv", newline="") as file:
            return list(csv.DictReader(file))

    def assert_refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stderr)
        lines = [line for line in done.stderr.splitlines() if "warning" not in line]
        self.assertEqual(len(lines), 1, done.stderr)
        for word in words:
            self.assertIn(word, lines[0])

    def results(self, output):
        """Each finished result, and what tells whether it was made again."""
        files = sorted((self.folder / output).glob("results/*/*.json"))
        return {file: (file.stat().st_ino, file.stat().st_mtime_ns) for file in files}


def timed(work, settings):
    """Totals of the machine in time, run directly."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([FFGPU, "time", str(work), "-o", folder, "--set", *settings], check=True,
                       stderr=subprocess.DEVNULL)
        with open(pathlib.Path(folder) / "stats.json") as file:
            return json.load(file)["totals"]["timing"]
