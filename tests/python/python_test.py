"""tools/python: its tables against the files as they are read by hand, and what the scripts draw."""
import csv
import importlib.util
import json
import os
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

FFGPU = os.environ["FFGPU_BINARY"]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
PYTHON = SOURCE / "tools" / "python"
MISSING = [name for name in ("numpy", "pandas", "matplotlib") if not importlib.util.find_spec(name)]


def ffgpu(*words):
    subprocess.run([FFGPU, *map(str, words)], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)


@unittest.skipIf(MISSING, "not installed: " + ", ".join(MISSING))
class PythonTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(PYTHON))
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="ffgpu_python_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.run_folder, cls.memory = cls.folder / "run", cls.folder / "memory.csv"
        work = cls.folder / "work.ffw"
        ffgpu("replay", SOURCE / "traces/light_maps.trace", "--frames", "0-1", "--no-images",
              "--timing", "-o", cls.run_folder, "--save-work", work)
        ffgpu("export", work, "--format", "csv", "-o", cls.memory)
        ffgpu("cache", work, "-o", cls.folder / "cache", "--layout", "linear,blocked")
        cls.stats = json.loads((cls.run_folder / "stats.json").read_text())
        # A sweep's table by hand: of one trace, two machines beat the others, one stood still.
        cls.sweep = cls.folder / "results.csv"
        cls.sweep.write_text("trace,point,stuck,cycles,memory_bytes,cost\n"
                             "a,p0,0,100,50,9\na,p1,0,90,60,8\na,p2,0,100,60,7\na,p3,1,0,0,0\n")

    def test_frames_have_the_counters_of_stats_json(self):
        from ffgpu_data import configuration, frames
        table = frames(self.run_folder)
        self.assertEqual(list(table.index), [0, 1])
        for frame in self.stats["frames"]:
            own = table.loc[frame["frame"]]
            self.assertEqual(own.total_cycles, frame["timing"]["total_cycles"])
            self.assertEqual(own.fragments_written, frame["functional"]["fragments_written"])
        self.assertEqual(configuration(self.run_folder)["texel_cache.ways"],
                         self.stats["configuration"]["texel_cache"]["ways"])

    def test_draws_have_the_fragments_and_bytes_that_were_counted_elsewhere(self):
        from ffgpu_data import draws, roofs, traffic
        table, moved = draws(self.run_folder), traffic(self.memory)
        self.assertEqual(table.fragments.sum(),
                         self.stats["totals"]["functional"]["fragments_written"])
        by_hand = {}
        with open(self.memory, newline="") as file:
            for row in csv.DictReader(file):
                if row["draw"]:
                    key = (int(row["draw"]), row["unit"])
                    by_hand[key] = by_hand.get(key, 0) + int(row["bytes"])
        self.assertGreaterEqual(len(by_hand), 4)
        for (draw, unit), count in by_hand.items():
            self.assertEqual(moved.loc[draw, unit], count)
        self.assertEqual(int(moved.to_numpy().sum()), sum(by_hand.values()))
        self.assertTrue((table.fragments / table.cycles
                         <= roofs(self.run_folder)["fragments_per_cycle"]).all())

    def test_curves_have_rates_of_their_counts(self):
        from ffgpu_data import miss_curves
        table = miss_curves(self.folder / "cache")
        with open(self.folder / "cache/curves.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(table), len(rows))
        for i in random.Random(1).sample(range(len(rows)), 50):
            self.assertAlmostEqual(table.miss_rate[i],
                                   int(rows[i]["misses"]) / int(rows[i]["accesses"]))
            self.assertEqual(table.is_full[i], rows[i]["sets"] == "1")

    def test_a_front_is_what_nothing_beats_and_a_stuck_machine_is_no_point(self):
        from ffgpu_data import pareto_front, sweep
        table = sweep(self.sweep)
        self.assertEqual(list(table.point), ["p0", "p1", "p2"])
        self.assertEqual(list(pareto_front(table, "memory_bytes", "cycles").point), ["p0", "p1"])
        self.assertEqual(list(pareto_front(table, "cost", "cycles").point), ["p2", "p1"])

    def test_a_run_without_timing_is_told_as_such(self):
        from ffgpu_data import draws, frames
        plain = self.folder / "plain"
        ffgpu("replay", SOURCE / "traces/light_maps.trace", "--frames", "0-0", "--no-images", "-o", plain)
        self.assertEqual(list(frames(plain).index), [0])
        self.assertRaisesRegex(ValueError, "plain: .* --timing", draws, plain)

    def test_each_layout_and_order_has_curves_of_its_own(self):
        ffgpu("cache", SOURCE / "traces/tour.trace", "--frames", "0-0", "-o", self.folder / "orders",
              "--layout", "linear,blocked", "--order", "scanline,tiled:8", "--line", "32")
        one = self.ink(self.draw("miss_rates", self.folder / "cache"))[1]
        four = self.ink(self.draw("miss_rates", self.folder / "orders"))[1]
        self.assertGreater(four[1], 1.5 * one[1])  # two rows of axes
        bare = self.folder / "bare"
        bare.mkdir()
        rows = (self.folder / "cache/curves.csv").read_text().splitlines()
        first = rows[1].split(",")
        (bare / "curves.csv").write_text(rows[0] + "\n" + ",".join(first[:11] + ["0"] * (len(first) - 11)) + "\n")
        self.assertIn("nothing to draw", self.refused("miss_rates", bare))

    def test_a_sweep_in_which_no_machine_came_to_an_end_has_no_front(self):
        bare = self.folder / "stuck"
        bare.mkdir()
        names = self.sweep.read_text().splitlines()[0]
        (bare / "results.csv").write_text(names + "\n")
        self.assertIn("no machine of the sweep came to an end", self.refused("pareto", bare))

    def refused(self, script, folder):
        """The line that it ends with where it has nothing to draw."""
        done = subprocess.run([sys.executable, "-B", PYTHON / "examples" / (script + ".py"), folder,
                               "-o", folder / "x.png"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertFalse((folder / "x.png").exists())
        return done.stderr.splitlines()[-1]

    def draw(self, script, *inputs):
        picture = self.folder / (script + ".png")
        done = subprocess.run([sys.executable, "-B", PYTHON / "examples" / (script + ".py"),
                               *inputs, "-o", picture], capture_output=True, text=True,
                              check=False, env=dict(os.environ, MPLCONFIGDIR=str(self.folder)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return picture

    def ink(self, picture):
        """The different colours of a picture, and its size."""
        from matplotlib import image
        pixels = (image.imread(picture)[:, :, :3] * 255).round().astype(int)
        colors = {tuple(color) for color in pixels.reshape(-1, 3)}
        header = picture.read_bytes()[16:24]
        return colors, struct.unpack(">II", header)

    def test_the_scripts_draw_their_figures(self):
        blue, vermilion, green = (0x00, 0x72, 0xb2), (0xd5, 0x5e, 0x00), (0x00, 0x9e, 0x73)
        for script, inputs, expected in [
                ("miss_rates", [self.folder / "cache"], {blue, vermilion, green}),
                ("roofline", [self.run_folder, self.memory], {(0x22, 0x22, 0x22)}),
                ("pareto", [self.sweep], {blue})]:
            with self.subTest(script=script):
                colors, (width, height) = self.ink(self.draw(script, *inputs))
                self.assertLessEqual(expected, colors)
                self.assertGreater(min(width, height), 400)


if __name__ == "__main__":
    unittest.main()
