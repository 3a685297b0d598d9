"""tools/python: its tables against the files as they are read by hand, what the scripts draw, and
the line that they end with where they cannot."""
import contextlib
import csv
import importlib.util
import io
import json
import os
import pathlib
import random
import runpy
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import warnings
from unittest import mock

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
        sys.path[:0] = [str(PYTHON), str(PYTHON / "examples")]
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="ffgpu_python_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        # Its own, so that matplotlib has nothing to say of the user's; also in refused_here().
        own = mock.patch.dict(os.environ, MPLCONFIGDIR=str(cls.folder))
        own.start()
        cls.addClassCleanup(own.stop)
        importlib.import_module("style")
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
        cls.plain = cls.folder / "plain"
        ffgpu("replay", SOURCE / "traces/light_maps.trace", "--frames", "0-0", "--no-images",
              "-o", cls.plain)

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
        from ffgpu_data import configuration, draws, frames, roofs
        self.assertEqual(list(frames(self.plain).index), [0])
        for function in (draws, roofs, configuration):
            self.assertRaisesRegex(ValueError, "plain: .* --timing", function, self.plain)

    def test_a_memory_of_one_latency_has_no_roof(self):
        from ffgpu_data import roofs
        machine = json.loads(json.dumps(self.stats["configuration"]))
        machine["memory"]["kind"] = "fixed"
        fixed = self.folder / "fixed.json"
        fixed.write_text(json.dumps(dict(self.stats, configuration=machine)))
        self.assertEqual(roofs(fixed)["bytes_per_cycle"], float("inf"))
        # The default: two buses of 32 bits, both edges, at the machine's clock.
        self.assertEqual(roofs(self.run_folder)["bytes_per_cycle"], 2 * 4 * 2)
        self.ink(self.draw("roofline", fixed, self.memory))

    def test_names_of_traces_and_points_are_text(self):
        from ffgpu_data import sweep
        names = ["007", "1e5", "NA"]
        with open(self.sweep, newline="") as file:
            header, *rows = csv.reader(file)
        for name, row in zip(names, rows):
            row[header.index("trace")] = row[header.index("point")] = name
        odd = self.folder / "odd_names.csv"
        with open(odd, "w", newline="") as file:
            csv.writer(file).writerows([header, *rows[:3]])
        table = sweep(odd)
        self.assertEqual(list(table.trace), list(table.point))
        self.assertLessEqual(set(table.trace), set(names))
        self.assertGreater(len(table), 1)

    def test_a_run_without_frames_has_tables_without_rows(self):
        from ffgpu_data import draws, frames
        own = ["width", "height", "api_calls", "pixels", "overdraw"]
        timed = self.stats["configuration"]
        for configuration, columns in [({}, own),
                                       (timed, own + ["milliseconds", "total_cycles"])]:
            bare = self.folder / "no_frames.json"
            bare.write_text(json.dumps(dict(self.stats, configuration=configuration, frame_count=0,
                                            totals={}, frames=[])))
            table = frames(bare)
            self.assertEqual((list(table.columns), table.index.name, len(table)),
                             (columns, "frame", 0))
            self.assertLessEqual(set(columns), set(frames(self.run_folder)))
            self.assertEqual(len(draws(bare)), 0)

    def test_a_table_without_rows_has_none_and_no_warning(self):
        from ffgpu_data import miss_curves, sweep, traffic
        for function, path in [(miss_curves, self.folder / "cache/curves.csv"),
                               (sweep, self.sweep), (traffic, self.memory)]:
            bare = self.folder / "header_only.csv"
            with open(path) as file:
                bare.write_text(file.readline())
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                self.assertEqual(len(function(bare)), 0)

    def test_a_file_that_is_none_of_its_kind_is_told_by_name(self):
        from ffgpu_data import draws, frames, miss_curves, roofs, sweep, traffic
        bad = self.folder / "bad"
        contents = {"empty": b"", "of other columns": b"a,b\n1,2\n", "ragged": b"a\n1,2\n3,4,5\n",
                    "not text": b"\xff\xfe\x00,", "of words": None, "other JSON": b"[1]"}
        for function, header in [(miss_curves, self.folder / "cache/curves.csv"),
                                 (sweep, self.sweep), (traffic, self.memory), (frames, None),
                                 (draws, None), (roofs, None)]:
            for name, content in contents.items():
                if content is None:
                    first = header.read_text().splitlines()[0] if header else "word"
                    content = (first + "\n" + ",".join(["word"] * len(first.split(",")))).encode()
                bad.write_bytes(content)
                with self.subTest(function=function.__name__, content=name):
                    self.assertRaisesRegex(ValueError, r"^\S*/bad: is not [^\n]+$", function, bad)
            self.assertRaises(FileNotFoundError, function, self.folder / "nothing")
            self.assertRaisesRegex(ValueError, "^'': expected .+$", function, "")

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
        self.assertIn("no texel was looked up", self.refused("miss_rates", bare))
        (bare / "curves.csv").write_text("\n".join(rows[:2]) + "\n")  # of one line
        self.assertIn("no cache of 512 bytes", self.refused("miss_rates", bare))

    def test_a_sweep_in_which_no_machine_came_to_an_end_has_no_front(self):
        bare = self.folder / "stuck"
        bare.mkdir()
        names = self.sweep.read_text().splitlines()[0]
        (bare / "results.csv").write_text(names + "\n")
        self.assertIn("no machine of the sweep came to an end", self.refused("pareto", bare))

    def test_what_the_scripts_cannot_read_or_write_is_one_line(self):
        empty, none, foreign = (self.folder / name for name in ("empty", "none.csv", "foreign.csv"))
        empty.mkdir()
        none.write_text("")
        foreign.write_text("a,b\n1,2\n")
        header = self.folder / "header.csv"
        with open(self.memory) as file:
            header.write_text(file.readline())
        missing, cache = self.folder / "missing", self.folder / "cache"
        self.assertIn("no draw of the run",
                      self.refused("roofline", self.run_folder, header))  # and no warning
        cases = [("roofline", [self.plain, self.memory], "plain: .* --timing")]
        for script, first, second, name in [("miss_rates", [], [], "curves.csv"),
                                            ("pareto", [], [], "results.csv"),
                                            ("roofline", [], [self.memory], "stats.json"),
                                            ("roofline", [self.run_folder], [], None)]:
            for path, expected in [
                    (missing, "missing: No such file or directory"),
                    (empty, f"empty/{name}: No such file" if name else "empty: Is a directory"),
                    (none, "none.csv: is not "), (foreign, "foreign.csv: is not "),
                    ("", "'': expected ")]:
                cases.append((script, [*first, path, *second], expected))
        outputs = [("miss_rates", [cache]), ("pareto", [self.sweep]),
                   ("roofline", [self.run_folder, self.memory])]
        cases = [(*case, self.folder / "x.png") for case in cases]
        cases += [(*case, "missing/x.png: No such file", missing / "x.png") for case in outputs]
        cases += [("miss_rates", [cache], "x.odd': expected .*png", self.folder / "x.odd"),
                  ("miss_rates", [cache], "-o '': expected ", "")]
        for script, inputs, expected, output in cases:
            with self.subTest(script=script, inputs=inputs, output=output):
                self.assertRegex(self.refused_here(script, *inputs, "-o", output),
                                 "^(?!.*\n).*" + expected)
                self.assertFalse((self.folder / "x.png").exists())

    def refused_here(self, script, *words):
        """The line of a script that ends with status 1, which is what Python makes of a line; a
        program of its own for each case would spend a second on pandas and matplotlib."""
        path = str(PYTHON / "examples" / (script + ".py"))
        printed = io.StringIO()
        with mock.patch("sys.argv", [path, *map(str, words)]), \
                contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed), \
                self.assertRaises(SystemExit) as ended:
            runpy.run_path(path, run_name="__main__")
        self.assertEqual(printed.getvalue(), "")
        self.assertIsInstance(ended.exception.code, str)
        return ended.exception.code

    def refused(self, script, *inputs):
        """The line that it ends with where it has nothing to draw."""
        picture = self.folder / "x.png"
        done = self.run_script(script, *inputs, "-o", picture)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertFalse(picture.exists())
        line, = done.stderr.splitlines()
        return line

    def run_script(self, script, *words):
        path = PYTHON / "examples" / (script + ".py")
        return subprocess.run([sys.executable, "-B", path, *words], capture_output=True, text=True,
                              check=False)

    def draw(self, script, *inputs):
        picture = self.folder / (script + ".png")
        done = self.run_script(script, *inputs, "-o", picture)
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
