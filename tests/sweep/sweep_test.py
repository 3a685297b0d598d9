"""ffgpu sweep on this machine: what its table says, what is killed and resumed, what is refused."""
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import time
import unittest

from sweep_tools import FFGPU, FRAMES, POINTS, SOURCE, SPACE, TRACE, SweepCase, timed


def unit_costs():
    text = (SOURCE / "docs/rtl_cost.md").read_text()
    return {unit: int(luts) for unit, luts in re.findall(r"^\| (\w+) \| (\d+) \|", text, re.M)}


class TableTest(SweepCase):
    def test_the_table_is_what_was_enumerated_by_hand_and_runs_one_by_one_give(self):
        self.swept("out")
        rows = self.rows("out")
        keys = ["texel_cache.sets", "texel_cache.ways", "raster.quads_per_cycle",
                "raster.traversal"]
        self.assertEqual([tuple(row[key] for key in keys) for row in rows], POINTS)
        work = self.folder / "work.ffw"
        subprocess.run([FFGPU, "replay", TRACE, *FRAMES, "--save-work", work], check=True,
                       stderr=subprocess.DEVNULL)
        for row in rows:
            totals = timed(work, [f"{key}={row[key]}" for key in keys])
            self.assertEqual(int(row["cycles"]), totals["total_cycles"])
            self.assertEqual(int(row["texel_cache_misses"]), totals["texel_cache_misses"])
            traffic = sum(value for name, value in totals.items()
                          if re.fullmatch(r"memory_[a-z_]+_(read|written)_bytes", name))
            self.assertEqual(int(row["memory_bytes"]), traffic)
            self.assertEqual(row["frames"], "1")

    def test_costs_and_fronts_equal_their_definitions(self):
        self.swept("out")
        rows, luts = self.rows("out"), unit_costs()
        # The first machine: 16 x 1 lines of 64 bytes, depth and colour caches of 64 x 4.
        pipe = sum(luts.get(unit, 0) for unit in [
            "apply_coverage", "depth_plane", "color_sum", "fog", "alpha_test", "stencil_depth",
            "blend", "quad_interlock", "texture_environment"])
        pipe += 9 * luts["attribute_plane"] + 4 * luts["reciprocal"]
        pipe += 4 * luts["filter_tree"] + 16 * luts["texel_decode"]
        bits = (16 + 2 * 64 * 4) * (64 * 8 + 32)
        self.assertEqual(int(rows[0]["cost"]), pipe + luts["tile_walker"] + bits // 16)
        for price, flag in [("memory_bytes", "best_by_bytes"), ("cost", "best_by_cost")]:
            for row in rows:
                own = (int(row["cycles"]), int(row[price]))
                others = [(int(other["cycles"]), int(other[price])) for other in rows]
                beaten = any(o != own and o[0] <= own[0] and o[1] <= own[1] for o in others)
                self.assertEqual(row[flag], "0" if beaten else "1")
        for kind in ["bytes", "cost"]:
            svg = (self.folder / "out" / f"pareto_{kind}_corridor.svg").read_text()
            self.assertEqual(svg.count("<circle"), len(POINTS))

    def test_random_samples_are_of_their_seed_and_a_larger_space_makes_only_what_is_new(self):
        space = ("[random]\nsamples = 3\nseed = {}\n"
                 "axes.texel_cache.sets = {{ from = 1, to = 256, powers_of_two = true }}\n")
        first = self.swept("out", space=space.format(1))
        self.assertEqual(self.swept("again", space=space.format(1)), first)
        self.assertNotEqual(self.swept("other", space=space.format(2)), first)
        before = self.results("out")
        self.swept("out", space=space.format(1).replace("samples = 3", "samples = 6"))
        after = self.results("out")
        self.assertGreater(len(after), len(before))
        self.assertEqual({file: after[file] for file in before}, before)

    def test_any_point_has_a_page_by_one_command(self):
        self.swept("out", traces=[TRACE, SOURCE / "traces/chrome.trace"])
        row = self.rows("out")[1]
        report = [FFGPU, "report", str(self.folder / "out"), "--point", row["point"]]
        done = subprocess.run(report, capture_output=True, text=True, check=False)
        self.assert_refused(done, "--trace", "corridor, chrome")
        subprocess.run([*report, "--trace", "corridor"], check=True, stdout=subprocess.DEVNULL)
        page = self.folder / "out/reports" / ("corridor-" + row["point"]) / "report.html"
        data = re.search(r'id="data">(.*?)</script>', page.read_text(), re.S)[1]
        run = json.loads(data)["runs"][0]
        self.assertEqual(sum(run["timing"]["total_cycles"]), int(row["cycles"]))
        self.assertEqual(sum(run["timing"]["texel_cache_misses"]), int(row["texel_cache_misses"]))
        done = subprocess.run([*report[:-1], "nowhere"], capture_output=True, text=True, check=False)
        self.assert_refused(done, "--trace")
        done = subprocess.run([*report[:-1], "nowhere", "--trace", "chrome"], capture_output=True,
                              text=True, check=False)
        self.assert_refused(done, "no point 'nowhere'")

    def test_a_point_of_a_trace_that_changed_since_has_no_page(self):
        trace = self.folder / "moved.trace"
        trace.write_bytes(TRACE.read_bytes())
        self.swept("out", traces=[trace])
        report = [FFGPU, "report", str(self.folder / "out"), "--point", self.rows("out")[0]["point"]]
        trace.write_bytes((SOURCE / "traces/chrome.trace").read_bytes())
        done = subprocess.run(report, capture_output=True, text=True, check=False)
        self.assert_refused(done, "moved.trace", "sweep it again")
        trace.write_bytes(TRACE.read_bytes())
        subprocess.run(report, stdout=subprocess.DEVNULL, check=True)

    def test_a_work_file_is_timed_as_it_is_and_two_traces_have_rows_of_their_own(self):
        work = self.folder / "kept.ffw"
        subprocess.run([FFGPU, "replay", TRACE, *FRAMES, "--save-work", work], check=True,
                       stderr=subprocess.DEVNULL)
        self.swept("out", traces=[work], frames=[])
        self.assertEqual(list((self.folder / "out/work").iterdir()), [])
        cycles = [row["cycles"] for row in self.rows("out")]
        self.swept("both", traces=[TRACE, SOURCE / "traces/chrome.trace"])
        self.assertEqual([row["cycles"] for row in self.rows("both")][:len(POINTS)], cycles)
        self.assertEqual({row["trace"] for row in self.rows("both")}, {"corridor", "chrome"})

    def test_the_last_axis_of_the_grid_changes_fastest(self):
        space = "[grid]\ntexel_cache.ways = [2, 1]\ntexel_cache.sets = [64, 16]\n"
        self.swept("out", space=space)
        got = [(row["texel_cache.ways"], row["texel_cache.sets"]) for row in self.rows("out")]
        self.assertEqual(got, [("2", "64"), ("2", "16"), ("1", "64"), ("1", "16")])

    def test_what_its_jobs_warn_of_is_told_once(self):
        work = self.folder / "kept.ffw"
        subprocess.run([FFGPU, "replay", TRACE, *FRAMES, "--save-work", work], check=True,
                       stderr=subprocess.DEVNULL)
        space = '[fixed]\ngpu.texture_filter = "elliptic"\n[grid]\ntexel_cache.sets = [16, 64]\n'
        for told in (1, 0):  # Nothing is made again.
            done = self.sweep("out", space=space, traces=[work], frames=[])
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr.count("ffgpu: warning: "), told, done.stderr)
            self.assertEqual(done.stderr.count("gpu.texture_filter"), told)

    def test_a_trace_is_drawn_with_values_where_a_point_needs_them(self):
        tour = SOURCE / "traces/tour.trace"
        usual = '[grid]\ndepth.test = ["as_gl_allows"]\n'
        space = ('[grid]\ndepth.test = ["as_gl_allows", "late"]\n'
                 'hierarchical_depth.keeps = ["off", "max"]\n')
        self.swept("out", space=usual, traces=[tour])
        before = self.results("out")
        cycles = self.rows("out")[0]["cycles"]
        # The work that is there has no values: it is drawn once more, and results stay.
        self.swept("out", space=space, traces=[tour])
        self.assertEqual({file: self.results("out")[file] for file in before}, before)
        rows = self.rows("out")
        self.assertEqual(len(rows), 4)
        self.assertEqual(rows[0]["cycles"], cycles)
        work = self.folder / "work.ffw"
        subprocess.run([FFGPU, "replay", tour, *FRAMES, "--save-work", work, "--work-values"],
                       check=True, stderr=subprocess.DEVNULL)
        for row in rows:
            keys = ["depth.test", "hierarchical_depth.keeps"]
            totals = timed(work, [f"{key}={row[key]}" for key in keys])
            self.assertEqual(int(row["cycles"]), totals["total_cycles"])
        self.swept("at_once", space=space, traces=[tour])
        self.assertEqual(self.rows("at_once"), rows)
        self.assertEqual(len(list((self.folder / "at_once/work").iterdir())), 1)


def process_of(name, folder):
    """Processes of this program, or of any, that work in the folder."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if len(words) > 1 and (not name or name in words[:2]) and any(str(folder).encode() in w for w in words):
            found.append(int(entry.name))
    return found


class KillTest(SweepCase):
    def kill_and_resume(self, kind, moment):
        output = "killed_%s_%d" % (kind, int(1e6 * moment))
        sweep = subprocess.Popen(self.command(output), stderr=subprocess.DEVNULL)
        time.sleep(moment)
        victims = [sweep.pid]
        if kind == "job":
            victims = process_of(b"time", self.folder / output) or victims
        for victim in victims:
            os.kill(victim, signal.SIGKILL)
        sweep.wait()
        finished = self.results(output)
        table = self.swept(output)
        after = self.results(output)
        # Jobs that were under way may have ended meanwhile; those that had are not made again.
        self.assertEqual({file: after[file] for file in finished}, finished)
        left = [file for file in (self.folder / output).rglob("*") if ".part" in file.name]
        self.assertEqual(left, [])
        return table

    def test_killed_at_any_moment_and_run_again_the_table_is_that_of_one_run(self):
        if "FFGPU_SWEEP_KILLS" not in os.environ:
            self.skipTest("FFGPU_SWEEP_KILLS is not set: ./dev sweep_kills runs it, which takes minutes")
        begin = time.monotonic()
        whole = self.swept("whole")
        duration = time.monotonic() - begin
        choose = random.Random(int(os.environ.get("FFGPU_SWEEP_SEED", "10")))
        for run in range(int(os.environ["FFGPU_SWEEP_KILLS"])):
            kind = ["sweep", "job"][run % 2]
            moment = choose.uniform(0.1, 1) * duration
            with self.subTest(kind=kind, moment=moment):
                self.assertEqual(self.kill_and_resume(kind, moment), whole)

    def test_ctrl_c_ends_the_sweep_and_all_that_it_began(self):
        begin = time.monotonic()
        whole = self.swept("whole")
        duration = time.monotonic() - begin
        for i in range(6):
            output = "interrupted_%d" % i
            sweep = subprocess.Popen(self.command(output), stderr=subprocess.DEVNULL,
                                     start_new_session=True)
            time.sleep((0.25 + 0.1 * i) * duration)
            os.killpg(sweep.pid, signal.SIGINT) # as a terminal does
            with self.subTest(moment=i):
                self.assertEqual(sweep.wait(timeout=20), -signal.SIGINT)
                self.assertEqual(process_of(b"", self.folder / output), [])
                self.assertEqual(self.swept(output), whole)

    def test_a_finished_sweep_does_nothing_again(self):
        table = self.swept("out")
        before = self.results("out")
        self.assertEqual(self.swept("out"), table)
        self.assertEqual(self.results("out"), before)


class MakeOnceTest(SweepCase):
    """make_once.sh, by which jobs make their files."""

    def make(self, file, script):
        once = SOURCE / "tools/sweep/flow/make_once.sh"
        return subprocess.run([once, file, "sh", "-c", script, "sh"], check=False).returncode

    def test_what_is_there_stays_and_nothing_runs(self):
        file = self.folder / "result"
        self.assertEqual(self.make(file, "echo first > $1"), 0)
        # Its time of access is no part of this: reading it below may move that on.
        before = (file.stat().st_ino, file.stat().st_mtime_ns)
        ran = self.folder / "ran"
        self.assertEqual(self.make(file, f"echo second > $1; touch {ran}"), 0)
        self.assertEqual(file.read_text(), "first\n")
        self.assertEqual((file.stat().st_ino, file.stat().st_mtime_ns), before)
        self.assertFalse(ran.exists())

    def test_what_comes_there_meanwhile_stays(self):
        file = self.folder / "result"
        self.assertEqual(self.make(file, f"echo other > {file}; echo own > $1"), 0)
        self.assertEqual(file.read_text(), "other\n")
        self.assertEqual(list(self.folder.iterdir()), [file])

    def test_nothing_is_no_file(self):
        self.assertEqual(self.make(self.folder / "result", "true"), 2)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_failure_leaves_nothing_and_a_stuck_machine_a_result(self):
        file = self.folder / "result"
        self.assertEqual(self.make(file, "echo half > $1; exit 2"), 2)
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertEqual(self.make(file, "echo stuck > $1; exit 3"), 0)
        self.assertEqual(file.read_text(), "stuck\n")


class RefusalTest(SweepCase):
    def test_a_space_that_is_none_is_one_line_with_file_and_line(self):
        for space, line, words in [
                ("[grid]\ntexel_cache.ways = []\n", 2, ["texel_cache.ways", "no value"]),
                ("[grid]\ntexel_cache.ways = { from = 4, to = 2 }\n", 2, ["no value"]),
                ("[grid]\ntexel_cache.ways = { from = 1, to = 8, powers_of_two = true, step = 2 }\n",
                 2, ["step"]),
                ("[grid]\n\ntexel_cache.wais = [1]\n", 3, ["texel_cache.ways"]),
                ("[grid]\ntexel_cache.ways = [1, 0]\n", 2, ["1 to 65536"]),
                ("[grid]\ntexel_cache.ways = 4\n", 2, ["[1, 2, 4]"]),
                ("[fixed]\ntexel_cache.ways = 1\n[grit]\na.b = [1]\n", 3, ["grit"]),
                ("[random]\nsamples = 0\naxes.texel_cache.ways = [1]\n", 1, ["samples"]),
                ("[grid]\n" + "".join("%s_cache.ways = { from = 1, to = 1000 }\n" % of
                                      for of in ("texel", "depth", "color")), 1, ["1000000 points"]),
                ("[grid\n", 1, [])]:
            with self.subTest(space=space):
                self.assert_refused(self.sweep("out", space=space), ".toml:%d:" % line, *words)
        self.assert_refused(self.sweep("out", space=""), "no point")
        self.assertFalse((self.folder / "out/results.csv").exists())

    def test_combinations_that_are_no_machine_are_left_out_and_the_others_are_whole(self):
        space = "[grid]\ncolor_cache.enable = [true, false]\nraster.quads_per_cycle = [1, 4]\n"
        done = self.sweep("out", space=space)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 combinations of 4 are no machines", done.stderr)
        self.assertIn("color_cache.enable", done.stderr)
        self.assertEqual([(row["color_cache.enable"], row["raster.quads_per_cycle"])
                          for row in self.rows("out")], [("true", "1"), ("true", "4"), ("false", "1")])

    def test_a_listed_point_or_a_whole_space_that_is_no_machine_and_a_base_that_there_is_not(self):
        listed = "[grid]\ntexel_cache.ways = [1]\n[[list]]\ncolor_cache.enable = false\nraster.quads_per_cycle = 4\n"
        self.assert_refused(self.sweep("out", space=listed), ".toml:4:", "list", "color_cache.enable")
        # The grid leaves it out; who lists it is told.
        also = ("[grid]\ncolor_cache.enable = [true, false]\nraster.quads_per_cycle = [1, 4]\n"
                "[[list]]\ncolor_cache.enable = false\nraster.quads_per_cycle = 4\n")
        self.assert_refused(self.sweep("out", space=also), ".toml:5:", "list", "color_cache.enable")
        whole = "[fixed]\ncolor_cache.enable = false\n[grid]\nraster.quads_per_cycle = [2, 4]\n"
        self.assert_refused(self.sweep("out", space=whole), "no point is a machine", "color_cache.enable")
        base = '\nbase = "preset:nope"\n[grid]\ntexel_cache.ways = [1]\n'
        self.assert_refused(self.sweep("out", space=base), ".toml:2:", "preset:nope")
        base = 'base = "nope.toml"\n[grid]\ntexel_cache.ways = [1]\n'
        self.assert_refused(self.sweep("out", space=base), ".toml:1:", "nope.toml")
        self.assertFalse((self.folder / "out").exists())

    def test_a_work_file_of_a_newer_version_and_a_damaged_trace_lose_nothing(self):
        table = self.swept("out")
        before = self.results("out")
        newer = self.folder / "newer.ffw"
        newer.write_bytes(b"FFGPUWRK" + (99).to_bytes(4, "little") + bytes(64))
        self.assert_refused(self.sweep("out", traces=[newer], frames=[]), "newer.ffw", "99")
        damaged = self.folder / "damaged.trace"
        damaged.write_bytes(TRACE.read_bytes()[:20000])
        self.assert_refused(self.sweep("out", traces=[TRACE, damaged]), "damaged.trace",
                            "results are missing")
        self.assertEqual({file: self.results("out")[file] for file in before}, before)
        self.assertEqual(self.swept("out"), table)

    def test_a_work_file_without_the_values_that_a_point_needs(self):
        work = self.folder / "masks.ffw"
        subprocess.run([FFGPU, "replay", TRACE, *FRAMES, "--save-work", work], check=True,
                       stderr=subprocess.DEVNULL)
        space = '[grid]\ndepth.test = ["as_gl_allows", "late"]\n'
        self.assert_refused(self.sweep("out", space=space, traces=[work], frames=[]),
                            "1 of 2 results are missing", "--work-values")
        self.assertEqual(len(self.rows("out")), 1)

    def test_a_full_disk_is_one_line_and_loses_nothing(self):
        small = self.folder / "small"
        small.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", small], check=False,
                          stderr=subprocess.DEVNULL).returncode != 0:
            self.skipTest("no file system of its own can be mounted here")
        self.addCleanup(subprocess.run, ["umount", "-l", str(small)], check=False)
        filler = small / "filler"
        filler.write_bytes(bytes(250 << 10))
        self.assert_refused(self.sweep("small/out"), "No space left on device")
        finished = self.results("small/out")
        filler.unlink()
        self.assertEqual(self.swept("small/out"), self.swept("roomy"))
        after = self.results("small/out")
        self.assertEqual({file: after[file] for file in finished}, finished)

    def test_another_versions_folder_is_refused(self):
        self.swept("out")
        plan = self.folder / "out/plan.json"
        plan.write_text(plan.read_text().replace('"ffgpu": "', '"ffgpu": "9'))
        self.assert_refused(self.sweep("out"), "another version's")

    def test_another_builds_folder_is_refused(self):
        table = self.swept("out")
        tools = self.folder / "prefix/tools"
        tools.mkdir(parents=True)
        flow = pathlib.Path(FFGPU).resolve().parent / "sweep"
        (tools / "sweep").symlink_to(flow)
        other = tools / "ffgpu"
        other.write_bytes(pathlib.Path(FFGPU).read_bytes() + b"\0") # It runs as before.
        other.chmod(0o755)
        command = [other, *self.command("out")[1:]]
        self.assert_refused(subprocess.run(command, capture_output=True, text=True, check=False),
                            "another build's")
        command = [other, *self.command("new")[1:]]
        subprocess.run(command, capture_output=True, check=True)
        self.assertEqual((self.folder / "new/results.csv").read_bytes(), table)

    def test_a_profile_that_there_is_not_is_told_in_snakemakes_words(self):
        self.assert_refused(self.sweep("out", "--profile", "nope"), "Snakemake: profile")


if __name__ == "__main__":
    unittest.main()
