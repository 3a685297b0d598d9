#!/usr/bin/env python3
"""What `ffgpu report` puts into a page: its numbers are those of stats.json, and add up."""

import json
import random
import re
import struct
import unittest
import zlib

import runs


def decoded(pixels):
    return "".join(letter * int(count) for letter, count in re.findall(r"([nkw])(\d+)", pixels))


def read_npy(path):
    """Binary32, a list of rows."""
    content = path.read_bytes()
    length = struct.unpack("<H", content[8:10])[0]
    height, width = map(int, re.search(rb"'shape': \((\d+), (\d+)\)", content[10:10 + length]).groups())
    values = struct.unpack(f"<{width * height}f", content[10 + length:])
    return [values[i * width:(i + 1) * width] for i in range(height)]


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = runs.folder()
        cls.folder = cls.place.__enter__()
        cls.addClassCleanup(cls.place.__exit__, None, None, None)
        cls.run_folder = runs.full_run(cls.folder / "run")
        runs.ffgpu("cache", runs.CORRIDOR, "--frames", "2-2", "-o", cls.run_folder, "--line", "64")
        cls.page = runs.report(cls.run_folder)
        cls.data = runs.data_of(cls.page)["runs"][0]
        cls.stats = runs.stats_of(cls.run_folder)

    def test_every_counter_sums_to_the_total_of_stats_json(self):
        for group in ("functional", "timing"):
            totals = self.stats["totals"][group]
            self.assertEqual(list(totals), list(self.data[group]))
            for name, column in self.data[group].items():
                self.assertEqual(sum(column), totals[name], name)
                self.assertEqual(column, [frame[group][name] for frame in self.stats["frames"]], name)

    def test_draws_sum_to_the_cycles_of_their_frame(self):
        for commands, frame in zip(self.data["commands"], self.stats["frames"], strict=True):
            self.assertEqual(sum(commands["cycles"]), frame["timing"]["total_cycles"])
            self.assertEqual(sum(commands["count"]), len(frame["commands"]))
            self.assertEqual(sum(commands["written"]), frame["functional"]["fragments_written"])
            self.assertEqual(sum(commands["covered"]), frame["functional"]["fragments_covered"])

    def test_what_the_machine_waited_for_and_bytes_by_client_add_up(self):
        timing = self.data["timing"]
        waited = [column for name, column in timing.items() if name.startswith("bottleneck_")]
        self.assertEqual(list(map(sum, zip(*waited))), timing["total_cycles"])
        traffic = {name: sum(column) for name, column in timing.items()
                   if re.fullmatch(r"memory_[a-z_]+_(read|written)_bytes", name)}
        self.assertEqual(sum(traffic.values()), sum(
            value for name, value in self.stats["totals"]["timing"].items()
            if re.fullmatch(r"memory_.*_(read|written)_bytes", name)))
        self.assertGreater(traffic["memory_texture_read_bytes"], 0)

    def test_the_series_sums_to_each_frame(self):
        series = self.data["series"]
        self.assertGreater(len(series["cycles"]), len(self.data["frames"]))
        self.assertEqual(series["joined"], 1)
        for name, column in series["columns"].items():
            sums = [0] * len(self.data["frames"])
            for frame, value in zip(series["frame"], column, strict=True):
                sums[frame] += value
            self.assertEqual(sums, self.data["timing"][name], name)

    def test_pixels_of_draws_are_those_of_the_overdraw_map(self):
        for place, frame in enumerate(self.stats["frames"]):
            written = read_npy(self.run_folder / f"heat_overdraw_{frame['frame']:04}.npy")
            mine = [[0] * frame["width"] for _ in range(frame["height"])]
            for box in filter(None, self.data["pixels"][place]):
                left, top, width, height, pixels = box
                letters = decoded(pixels)
                self.assertEqual(len(letters), width * height)
                for at in (i for i, letter in enumerate(letters) if letter == "w"):
                    mine[top + at // width][left + at % width] += 1
            for ours, theirs in zip(mine, written, strict=True):
                self.assertTrue(all(a <= b and (a > 0) == (b > 0) for a, b in zip(ours, theirs, strict=True)))

    def test_facts_of_draws_are_those_of_draws_csv(self):
        lines = (self.run_folder / "draws.csv").read_text().splitlines()
        names = lines[0].split(",")
        told = {(row["frame"], row["draw"]): row for row in (dict(zip(names, line.split(","))) for line in lines[1:])
                if row["kind"] == "draw"}
        facts, kinds = self.data["facts"], self.data["kinds"]
        found = 0
        for place, commands in enumerate(self.data["commands"]):
            for entry, kind in enumerate(commands["kind"]):
                if kinds[kind] != "draw":
                    continue
                row = told[str(self.data["frames"][place]["frame"]), str(commands["draw"][entry])]
                shown = [facts["texts"][text] for text in facts["places"][place][entry]]
                self.assertEqual(shown, [row[name] for name in facts["columns"]])
                self.assertEqual(commands["cycles"][entry], int(row["cycles"]))
                found += 1
        self.assertEqual(found, len(told))
        self.assertIn("textures", facts["columns"])

    def test_curves_are_those_of_the_file(self):
        lines = (self.run_folder / "curves.csv").read_text().splitlines()
        names = lines[0].split(",")
        rows = [dict(zip(names, line.split(","))) for line in lines[1:]]
        curve = self.data["curves"][0]
        two_ways = {int(row["bytes"]): int(row["misses"]) for row in rows if row["ways"] == "2"}
        self.assertEqual({size: misses for size, misses in curve["ways"]["2"]}, two_ways)
        self.assertEqual(curve["accesses"], int(rows[0]["accesses"]))
        self.assertIn("full", curve["ways"])

    def test_the_same_folder_gives_the_same_page_which_asks_nobody(self):
        before = self.page.read_bytes()
        self.assertEqual(runs.report(self.run_folder).read_bytes(), before)
        text = before.decode()
        self.assertIn("default-src 'none'", text)
        self.assertIsNone(re.search(r"""(src|href)=["']?(https?:|//)""", text))

    def test_a_run_without_all_of_it_says_what_would_fill_the_page(self):
        plain = runs.replay(self.folder / "plain", frames="2-2")
        notes = runs.data_of(runs.report(plain))["runs"][0]["notes"]
        for part, wanted in (("series", "series.interval_cycles"), ("pixels", "--draw-pixels"), ("draws", "--per-draw"),
                             ("pictures", "--heatmap"), ("curves", "ffgpu cache")):
            self.assertIn(wanted, notes[part][0])
        runs.ffgpu("replay", runs.CORRIDOR, "-o", self.folder / "untimed", "--frames", "2-2")
        self.assertIn("--timing", runs.data_of(runs.report(self.folder / "untimed"))["runs"][0]["notes"]["timing"][0])

    def test_files_of_another_run_are_left_out(self):
        mixed = runs.full_run(self.folder / "mixed")
        runs.ffgpu("cache", runs.CORRIDOR, "-o", mixed, "--frames", "2-4")
        runs.replay(mixed, "--set", "texel_cache.ways=1")
        data = runs.data_of(runs.report(mixed))["runs"][0]
        self.assertNotIn("series", data)
        self.assertIn("another run", data["notes"]["series"][0])
        self.assertIn("pixels", data)  # The machine decides on neither these nor on curves' reads.
        self.assertNotIn("curves", data["notes"])

    def test_pixels_of_another_trace_are_left_out_and_curves_told_of(self):
        mixed = runs.full_run(self.folder / "mixed_traces")
        runs.ffgpu("cache", runs.CORRIDOR, "-o", mixed, "--frames", "2-4")
        runs.ffgpu("replay", runs.ROOT / "traces" / "light_maps.trace", "-o", mixed, "--frames", "2-4", "--timing")
        data = runs.data_of(runs.report(mixed))["runs"][0]
        self.assertNotIn("pixels", data)
        self.assertIn("draw_pixels.csv is of another run", data["notes"]["pixels"][0])
        self.assertIn("curves", data)  # Those of a whole trace go with a few of its frames.
        self.assertIn("curves.csv is of other work", data["notes"]["curves"][0])

    def test_draws_of_frames_that_the_run_does_not_have_are_left_out(self):
        mixed = runs.full_run(self.folder / "mixed_frames")
        runs.replay(mixed, "--no-images", frames="6-7")
        data = runs.data_of(runs.report(mixed))["runs"][0]
        for part, file in (("facts", "draws.csv"), ("pixels", "draw_pixels.csv")):
            self.assertNotIn(part, data)
            self.assertIn(f"{file} is of another run", data["notes"]["draws" if part == "facts" else part][0])


class PicturesOfOthers(unittest.TestCase):
    def setUp(self):
        place = runs.folder()
        self.folder = place.__enter__()
        self.addCleanup(place.__exit__, None, None, None)

    def shown(self, run):
        """The maps of each frame, and what is said of pictures."""
        data = runs.data_of(runs.report(run))["runs"][0]
        return [sorted(one) for one in data["pictures"]["frames"]], " ".join(data["notes"].get("pictures", []))

    def test_maps_of_an_older_machine_are_left_out(self):
        run = runs.replay(self.folder / "run", "--heatmap", "cycles", "--view", "depth")
        self.assertEqual(self.shown(run)[0], [["frame", "heat_cycles", "view_depth"]] * 3)
        runs.replay(run, "--no-images", "--set", "texel_cache.ways=1")
        shown, said = self.shown(run)
        self.assertEqual(shown, [[]] * 3)
        self.assertIn("Pictures of another run than stats.json are left out: 9 (frame, heat_cycles, view_depth).", said)
        runs.replay(run, "--set", "texel_cache.ways=1")
        shown, said = self.shown(run)
        self.assertEqual(shown, [["frame"]] * 3)
        self.assertIn("Pictures of another run than stats.json are left out: 6 (heat_cycles, view_depth).", said)

    def test_frames_of_another_trace_are_left_out(self):
        run = self.folder / "run"
        runs.ffgpu("replay", runs.ROOT / "traces" / "chrome.trace", "-o", run, "--frames", "2-3")
        runs.replay(run, "--no-images", "--heatmap", "cycles", frames="2-2")
        shown, said = self.shown(run)
        self.assertEqual(shown, [["heat_cycles"]])
        self.assertIn("Pictures of another run than stats.json are left out: 1 (frame).", said)

    def test_statistics_of_a_work_file_go_with_pictures_of_the_same_work_and_machine(self):
        run, work = self.folder / "run", self.folder / "kept.ffw"
        runs.replay(run, "--heatmap", "cycles", "--save-work", work, frames="2-2")
        listed = (run / "pictures.csv").read_bytes()
        runs.ffgpu("time", work, "-o", run)
        self.assertEqual(self.shown(run)[0], [["frame", "heat_cycles"]])
        runs.ffgpu("time", work, "-o", run, "--set", "texel_cache.ways=1")
        shown, said = self.shown(run)
        self.assertEqual(shown, [[]])
        self.assertIn("of another run", said)
        self.assertEqual((run / "pictures.csv").read_bytes(), listed)
        runs.ffgpu("replay", runs.CORRIDOR, "-o", run, "--frames", "2-2")  # Frames depend on no machine.
        runs.ffgpu("time", work, "-o", run)
        self.assertEqual(self.shown(run)[0], [["frame"]])

    def test_the_list_is_the_same_for_any_number_of_threads(self):
        one, many = (runs.replay(self.folder / threads, "--heatmap", "cycles", "--threads", threads)
                     for threads in ("1", "3"))
        lines = (one / "pictures.csv").read_text()
        self.assertEqual(lines, (many / "pictures.csv").read_text())
        for line, frame in zip(lines.splitlines()[1:], runs.stats_of(one)["frames"], strict=True):
            counted = frame["functional"]
            self.assertEqual(line, f"{frame['frame']},{counted['fragments_covered']},{counted['fragments_written']},"
                                   f"{frame['timing']['total_cycles']},frame heat_cycles")

    def test_without_a_list_all_pictures_count(self):
        run = runs.replay(self.folder / "run", "--heatmap", "cycles", frames="2-2")
        runs.replay(run, "--no-images", frames="2-2")
        (run / "pictures.csv").unlink()
        self.assertEqual(self.shown(run)[0], [["frame", "heat_cycles"]])


class Difference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = runs.folder()
        cls.folder = place.__enter__()
        cls.addClassCleanup(place.__exit__, None, None, None)
        cls.first = runs.replay(cls.folder / "four")
        cls.second = runs.replay(cls.folder / "one", "--set", "texel_cache.ways=1")
        cls.changes = runs.data_of(runs.report(cls.first, cls.second, output="difference.html"))["difference"]

    def test_the_one_parameter_that_differs_is_told(self):
        self.assertEqual(self.changes["configuration"], [{"name": "texel_cache.ways", "before": 4, "after": 1}])

    def test_effects_are_the_figures_of_both_the_largest_first(self):
        before, after = (runs.stats_of(run)["totals"]["timing"] for run in (self.first, self.second))
        figures = self.changes["figures"]
        self.assertGreater(len(figures), 20)
        sizes = [abs(one["after"] - one["before"]) / max(1, one["whole"]) for one in figures]
        self.assertEqual(sizes, sorted(sizes, reverse=True))
        for one in figures:
            self.assertEqual((one["before"], one["after"]), (before[one["name"]], after[one["name"]]))
            self.assertNotEqual(one["before"], one["after"])
        waited = [one for one in figures if one["name"].startswith("bottleneck_")]
        self.assertEqual(sum(one["after"] - one["before"] for one in waited),
                         after["total_cycles"] - before["total_cycles"])
        self.assertIn("texel_cache_conflict_misses", [one["name"] for one in figures])

    def difference_to(self, *settings):
        other = runs.replay(self.folder / "-".join(settings), "--set", *settings)
        runs.ffgpu("report", other, self.first, "-o", self.folder / "other.html")
        return runs.data_of(self.folder / "other.html")["difference"]["figures"]

    def test_what_has_no_whole_to_be_a_part_of_comes_last(self):
        figures = self.difference_to("raster.architecture=tile_based")
        wholes = [one["whole"] for one in figures]
        self.assertIn(0, wholes)  # The first run has no cache of colours.
        self.assertNotIn(0, wholes[:wholes.index(0)])
        self.assertEqual(set(wholes[wholes.index(0):]), {0})

    def test_bottlenecks_of_one_run_alone_are_no_effect(self):
        figures = self.difference_to("bottlenecks.enable=false", "texel_cache.ways=1")
        self.assertGreater(len(figures), 20)
        self.assertEqual([one for one in figures if one["name"].startswith("bottleneck_")], [])

    def test_equal_runs_differ_in_nothing(self):
        runs.ffgpu("report", self.first, self.first, "-o", self.folder / "same.html")
        changes = runs.data_of(self.folder / "same.html")["difference"]
        self.assertEqual(changes, {"configuration": [], "figures": []})

    def test_runs_of_different_work_are_refused(self):
        other = self.folder / "other"
        runs.ffgpu("replay", runs.ROOT / "traces" / "chrome.trace", "-o", other, "--frames", "2-4", "--timing")
        refused = runs.ffgpu("report", self.first, other, status=2)
        self.assertRegex(refused, r"^ffgpu: .*no runs of the same trace: in frame 2 .*\n$")
        fewer = runs.replay(self.folder / "fewer", frames="2-3")
        self.assertRegex(runs.ffgpu("report", self.first, fewer, status=2), r"^ffgpu: .*2 to 4.*2 to 3.*\n$")
        untimed = self.folder / "untimed"
        runs.ffgpu("replay", runs.CORRIDOR, "-o", untimed, "--frames", "2-4")
        self.assertRegex(runs.ffgpu("report", self.first, untimed, status=2), r"^ffgpu: .*no timing.*\n$")
        self.assertFalse((other / "difference.html").exists())


class BadInput(unittest.TestCase):
    def refused(self, folder, wanted):
        said = runs.ffgpu("report", folder, status=2)
        self.assertRegex(said, rf"^ffgpu: [^\n]*{wanted}[^\n]*\n$")

    def test_what_is_no_run_is_named(self):
        with runs.folder() as folder:
            self.refused(folder / "none", "is no folder")
            self.refused(folder, "has no stats.json")
            for text, wanted in (("", "cut off or damaged"), ("[]", "no statistics file"), ("7", "no statistics file"),
                                 ('{"schema_version": 9, "frames": []}', "schema_version"),
                                 ('{"schema_version": 2}', "expected frames"),
                                 ('{"schema_version": 2, "frames": []}', "none of the frames"),
                                 ('{"schema_version": 2, "frames": [{"frame": -1}]}', "expected a count"),
                                 ('{"schema_version": 2, "frames": [{"frame": 0}]}', "no statistics file")):
                (folder / "stats.json").write_text(text)
                self.refused(folder, wanted)

    def test_damaged_files_are_named_and_the_former_page_stays(self):
        with runs.folder() as folder:
            run = runs.full_run(folder / "run")
            page = runs.report(run).read_bytes()
            whole = (run / "stats.json").read_text()
            source = random.Random(7)
            for _ in range(20):
                (run / "stats.json").write_text(whole[:source.randrange(len(whole) - 2)])
                self.refused(run, "stats.json")
            (run / "stats.json").write_text(whole)
            for name, damage, wanted in (
                    ("series.csv", lambda text: text[:-20], "cut off"),
                    ("series.csv", lambda text: text.replace("\n", "\n1,", 1), "values, expected"),
                    ("series.csv", lambda text: text.replace("cycles", "x"), "has no column"),
                    ("draw_pixels.csv", lambda text: text.replace("\n2,draw,", "\n2x,draw,"), "expected a number"),
                    ("pictures.csv", lambda text: text[:-5], "cut off"),
                    ("frame_0003.png", lambda text: text[:5], "frame_0003.png: is no PNG"),
                    ("frame_0003.png", lambda text: text[:9], "frame_0003.png: is a damaged PNG"),
                    ("frame_0003.png", lambda text: text[:3000], "frame_0003.png: is a damaged PNG"),
                    ("frame_0003.png", lambda text: text[:-1], "frame_0003.png: is a damaged PNG"),
                    ("heat_cycles_0003.png", lambda text: text[:-20], "heat_cycles_0003.png: is a damaged PNG")):
                kept = (run / name).read_bytes()
                (run / name).write_bytes(damage(kept.decode("latin-1")).encode("latin-1"))
                self.refused(run, wanted)
                (run / name).write_bytes(kept)
            self.assertEqual((run / "report.html").read_bytes(), page)
            said = runs.ffgpu("report", run, "-o", "/dev/full", status=2)
            self.assertRegex(said, r"^ffgpu: /dev/full: .*\n$")


class DamagedPictures(unittest.TestCase):
    def test_each_bit_of_a_picture_counts(self):
        with runs.folder() as folder:
            run = runs.replay(folder / "run", frames="2-2")
            picture = run / "frame_0002.png"
            whole = picture.read_bytes()
            source = random.Random(3)
            ends = [*range(8, 33), *range(len(whole) - 16, len(whole))]  # the head, the last checksums
            for place in [*ends, *(source.randrange(len(whole)) for _ in range(20))]:
                flipped = bytearray(whole)
                flipped[place] ^= 1 << source.randrange(8)
                picture.write_bytes(flipped)
                self.assertRegex(runs.ffgpu("report", run, status=2),
                                 r"^ffgpu: [^\n]*frame_0002\.png: is a damaged PNG[^\n]*\n$", place)
            picture.write_bytes(whole)
            runs.report(run)


def png(width, height, pixels):
    """A picture that nothing compresses."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    rows = b"".join(b"\0" + pixels[3 * width * y:3 * width * (y + 1)] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 0)) +
            chunk(b"IEND", b""))


class Size(unittest.TestCase):
    def test_a_hundred_frames_of_noise_stay_below_20_mb(self):
        width, height, count = 640, 480, 100
        with runs.folder() as folder:
            run = runs.replay(folder / "run", "--draw-pixels", frames="2-2")
            stats = runs.stats_of(run)
            frame = dict(stats["frames"][0], width=width, height=height)
            stats["frames"] = [dict(frame, frame=i) for i in range(count)]
            (run / "stats.json").write_text(json.dumps(stats))
            (run / "pictures.csv").unlink()  # It tells of the one frame that was drawn.
            noise = random.Random(1).randbytes(3 * width * height)
            picture = png(width, height, noise)
            for i in range(count):
                (run / f"frame_{i:04}.png").write_bytes(picture)
            page = runs.report(run)
            self.assertLess(page.stat().st_size, 20_000_000)
            pictures = runs.data_of(page)["runs"][0]["pictures"]
            self.assertGreater(pictures["shrunk"], 1)
            self.assertTrue(all("frame" in one for one in pictures["frames"]))
            self.assertIn("shrunk", runs.data_of(page)["runs"][0]["notes"]["pictures"][-1])


if __name__ == "__main__":
    unittest.main()
