#!/usr/bin/env python3
"""Runs piglit tests on ffgpu's drop-in libGL and prints a table by area beside Mesa's results.

    tests/conformance/conformance.py --build build [--list LIST.tsv] [--short] [--filter REGEX] [-v]

LIST.tsv names area, name and command of each test, whether it needs the screen alone (serial) or
takes long (slow), its tier, and what Mesa's softpipe and llvmpipe made of it when restricted to
OpenGL 1.5. Needs Debian's packages piglit and xvfb. --short runs a stratified part: each
area's quickest tests. Exit status 1 if a test that a Mesa driver passes does not pass here, except for those
that known_gaps.tsv names with their reason.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
PIGLIT = os.environ.get("PIGLIT_DIR", "/usr/lib/x86_64-linux-gnu/piglit")
GOOD = ("pass", "warn")


def read_list(path):
    with open(path) as file:
        rows = [line.rstrip("\n").split("\t") for line in file if line.strip()]
    return [dict(zip(rows[0], row)) for row in rows[1:]]


def known_gaps():
    """Name -> reason of the tests that are known not to pass yet."""
    with open(os.path.join(HERE, "known_gaps.tsv")) as file:
        return dict(line.rstrip("\n").split("\t", 1) for line in file if line.strip() and not line.startswith("#"))


def stratified(tests, per_area=3):
    """The quickest few of each area, among those that a reference passes: core and the time's extensions."""
    chosen = collections.defaultdict(list)
    for test in sorted(tests, key=lambda t: float(t["sec_llvmpipe"] or 0)):
        passes = test["tier"] in ("core", "era", "glx") and (test["llvmpipe"] in GOOD or test["softpipe"] in GOOD)
        if passes and test["slow"] != "1" and len(chosen[test["area"]]) < per_area:
            chosen[test["area"]].append(test)
    return [test for area in sorted(chosen) for test in chosen[area]]


def verdict(output, status, timed_out):
    """The result by piglit's own rules."""
    if timed_out:
        return "timeout"
    if status < 0 or status in (134, 136, 139):
        return "crash"
    result = None
    for line in output.splitlines():
        if line.startswith("PIGLIT:"):
            try:
                result = json.loads(line[7:]).get("result", result)
            except ValueError:
                pass
    if status != 0:
        return "warn" if result == "pass" else "fail"
    return result if result in ("pass", "warn", "skip") else "fail"


class XServer:
    """An Xvfb of our own on a free display."""

    def __enter__(self):
        reader, writer = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1280x1024x24", "+extension", "GLX", "-noreset", "-nolisten", "tcp"],
            pass_fds=(writer,), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as file:
            number = file.readline().strip()
        if not number:
            sys.exit("conformance: Xvfb did not start")
        self.display = ":" + number
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def run(test, display, library, timeout):
    environment = dict(os.environ, DISPLAY=display, PIGLIT_SOURCE_DIR=PIGLIT, PIGLIT_PLATFORM="glx")
    environment["LD_LIBRARY_PATH"] = ":".join(p for p in (library, os.environ.get("LD_LIBRARY_PATH")) if p)
    command = shlex.split(test["command"])
    if not command[0].startswith("/"):
        command[0] = os.path.join(PIGLIT, "bin", command[0])
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile("w+b") as out:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                   cwd=folder, env=environment, start_new_session=True)
        timed_out = False
        try:
            status = process.wait(timeout * (10 if test["slow"] == "1" else 1))
        except subprocess.TimeoutExpired:
            timed_out = True
            os.killpg(process.pid, signal.SIGKILL)
            status = process.wait()
        out.seek(0)
        text = out.read(1 << 22).decode("utf-8", "replace")
    return verdict(text, status, timed_out), text


def table(tests, results):
    areas = collections.defaultdict(list)
    for test in tests:
        areas[test["area"]].append(test)
    print(f"{'area':24s} {'tests':>5s} {'pass':>5s} {'fail':>5s} {'skip':>5s} {'other':>5s}  softpipe llvmpipe")
    totals = collections.Counter()
    for area in sorted(areas) + [None]:
        if area is None:
            counts = totals
        else:
            counts = collections.Counter(tests=len(areas[area]))
            for test in areas[area]:
                result = results[test["name"]]
                counts["pass" if result in GOOD else result if result in ("fail", "skip") else "other"] += 1
                for peer in ("softpipe", "llvmpipe"):
                    counts[peer] += test[peer] in GOOD
            totals.update(counts)
        print(f"{area or 'all':24s} {counts['tests']:5d} {counts['pass']:5d} {counts['fail']:5d} {counts['skip']:5d} "
              f"{counts['other']:5d}  {counts['softpipe']:8d} {counts['llvmpipe']:8d}")
    return totals


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build")
    parser.add_argument("--list", default=os.path.join(HERE, "piglit.tsv"))
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--filter", default="")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=60)
    parser.add_argument("-v", "--verbose", action="store_true", help="print the output of tests that do not pass")
    options = parser.parse_args()
    if not os.path.isdir(os.path.join(PIGLIT, "bin")):
        print("piglit is not installed: conformance is skipped\n0 passed, 0 failed, 1 skipped")
        return 0

    tests = [t for t in read_list(options.list) if re.search(options.filter, t["name"]) or re.search(options.filter, t["area"])]
    if options.short:
        tests = stratified(tests)
    library = os.path.abspath(os.path.join(options.build, "driver", "GL"))
    results = {}
    with XServer() as server:
        def work(test):
            result, text = run(test, server.display, library, options.timeout)
            results[test["name"]] = result
            if options.verbose and result not in GOOD:
                print(f"--- {result}: {test['name']}\n{text[-1500:]}", flush=True)

        together = [t for t in tests if t["serial"] != "1"]
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            list(pool.map(work, together))
        for test in tests:  # These look at the screen: alone.
            if test["serial"] == "1":
                work(test)

    worse = [t for t in tests if results[t["name"]] not in GOOD and (t["llvmpipe"] in GOOD or t["softpipe"] in GOOD)]
    gaps = known_gaps()
    for test in worse:
        reason = f"   known: {gaps[test['name']]}" if test["name"] in gaps else ""
        print(f"worse than Mesa: {results[test['name']]:8s} {test['tier']:5s} {test['name']}{reason}")
    worse = [test for test in worse if test["name"] not in gaps]
    for test in tests:
        if results[test["name"]] in GOOD and test["llvmpipe"] not in GOOD and test["softpipe"] not in GOOD:
            print(f"better than Mesa: {test['tier']:5s} {test['name']}")
    totals = table(tests, results)
    print(f"{totals['pass']} passed, {len(worse)} failed, {totals['tests'] - totals['pass'] - len(worse)} skipped")
    return 1 if worse else 0


sys.exit(main())
