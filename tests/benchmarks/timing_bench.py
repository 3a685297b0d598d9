#!/usr/bin/env python3
"""What the machine in time costs: microseconds a quad and a memory request, of traces.

    timing_bench.py --build build [--before OTHER_BUILD] [--frames 1-2] [--rounds 3]
                    [--set NAME=VALUE] TRACE ...

Each build replays the frames without the machine and with it, with the default memory and the ideal
one; the machine's cost is the difference. Builds take turns, the best of the rounds counts. `cpu`
is processor time of all threads, `wall` what passes. Quads and requests are those of the first
build: another version of the model may count a little otherwise.
"""

import argparse
import json
import resource
import subprocess
import tempfile
import time
from pathlib import Path

# Of a build that knows no profiles the nearest to an ideal memory.
IDEAL = ("memory.profile=ideal",)
IDEAL_WITHOUT_PROFILES = tuple(f"memory.{name}_cycles=0" for name in
                               ("row_to_column", "column", "precharge", "turnaround"))


def run(command):
    """Seconds of the processor and of the clock that the command takes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.monotonic()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wall = time.monotonic() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return cpu, wall


class Build:
    def __init__(self, folder, scratch, settings=()):
        self.settings = settings
        self.program = Path(folder) / "tools/ffgpu"
        self.out = scratch / f"{len(list(scratch.iterdir()))}"
        self.out.mkdir()
        config = subprocess.run([self.program, "config"], check=True, capture_output=True, text=True)
        self.ideal = IDEAL if "\nprofile = " in config.stdout else IDEAL_WITHOUT_PROFILES

    def replay(self, trace, frames, settings):
        options = [] if settings is None else ["--timing"]
        for setting in (*settings, *self.settings) if settings is not None else ():
            options += ["--set", setting]
        return run([self.program, "replay", trace, "-o", self.out, "--frames", frames,
                    "--no-images", *options])

    def counts(self):
        """Quads and memory requests of the last replay() with the machine."""
        totals = json.loads((self.out / "stats.json").read_text())["totals"]
        timing = totals["timing"]
        requests = sum(timing[f"memory_row_{kind}"] for kind in ("hits", "misses", "conflicts"))
        return totals["functional"]["quads"], requests


def measure(builds, trace, frames, rounds):
    """Rows of one trace: memory, quads, requests, and the (cpu, wall) of each build's machine."""
    kinds = {"none": [None] * len(builds),
             "default": [()] * len(builds),
             "ideal": [build.ideal for build in builds]}
    best = {}
    counts = {}
    for _ in range(rounds):
        for kind, settings in kinds.items():
            for i, build in enumerate(builds):
                seconds = build.replay(trace, frames, settings[i])
                best[kind, i] = tuple(map(min, best.get((kind, i), seconds), seconds))
            if kind != "none":
                counts[kind] = builds[0].counts()
    for kind in ("default", "ideal"):
        yield kind, *counts[kind], [tuple(a - b for a, b in zip(best[kind, i], best["none", i]))
                                    for i in range(len(builds))]


def print_row(trace, row):
    memory, quads, requests, seconds = row
    cells = [trace.stem, memory]
    for cpu, wall in seconds:
        cells += [f"{1e6 * cpu / quads:.2f}", f"{1e6 * wall / quads:.2f}",
                  f"{1e6 * wall / requests:.2f}"]
    if len(seconds) == 2:
        cells += [f"{seconds[1][i] / seconds[0][i]:.2f}" for i in (0, 1)]
    print("| " + " | ".join(cells) + " |", flush=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--build", default="build")
    arguments.add_argument("--before", help="a build to compare with")
    arguments.add_argument("--frames", default="1-2")
    arguments.add_argument("--rounds", type=int, default=3)
    arguments.add_argument("--set", action="append", default=[], metavar="NAME=VALUE",
                           help="of the machine of --build alone: bottlenecks.enable=off")
    arguments.add_argument("traces", nargs="+", type=Path)
    options = arguments.parse_args()
    names = ["now", "before"] if options.before else ["now"]
    head = ["trace", "memory"]
    for name in names:
        head += [f"{name}: cpu us/quad", "wall us/quad", "wall us/request"]
    head += ["cpu, times less", "wall, times less"] if options.before else []
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    with tempfile.TemporaryDirectory() as scratch:
        folders = [options.build] + ([options.before] if options.before else [])
        builds = [Build(folder, Path(scratch), options.set if i == 0 else ())
                  for i, folder in enumerate(folders)]
        for trace in options.traces:
            for row in measure(builds, trace, options.frames, options.rounds):
                print_row(trace, row)


if __name__ == "__main__":
    main()
