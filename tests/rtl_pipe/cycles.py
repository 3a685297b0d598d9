#!/usr/bin/env python3
"""cycles.py BUILD [--frames A-B] [--trends] [TRACE ...]: cycles of the machine in time configured as
the fragment pipe in RTL (preset:rtl_pipe), beside those of the Verilated pipe, on the same draws.

Prints a table for each trace: all draws together, how many of them agree within 10 %, and the busy
cycles of each unit. Exit status 1 where a trace's total, or a unit's busy cycles, differ by more
than 5 %, or fewer than 95 % of the draws agree. --trends: totals over sizes of the texel cache, of
its queue and latencies of the memory; 1 where model and RTL part in a sign.
"""
import argparse
import csv
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from verilated_tree import build_tree

Root = Path(__file__).resolve().parents[2]
Units = ["raster", "interpolator", "texture", "fragment", "depth", "color"]
Traces = ["glxgears", "polyhedra", "chromium", "stairs", "corridor", "lattice", "chrome", "light_maps",
          "gallery/projective_texture", "gallery/wrap_modes"]
OnlyFrame = {"gallery/projective_texture": "0-0", "gallery/wrap_modes": "0-0"}  # Others: frame 1.
Total, Draw, Unit = 0.05, 0.10, 0.05
Span = re.compile(r'\{"name":"([^"]+)","ph":"X","ts":(\d+),"dur":(\d+),"pid":(\d+),"tid":(\d+)\}')
Name = re.compile(r'"name":"thread_name","ph":"M","pid":1,"tid":(\d+),"args":\{"name":"([^"]+)"\}')


class Cycles:
    """Of a draw: all, and the busy ones of each unit."""
    def __init__(self, total=0, busy=None):
        self.total, self.busy = total, busy or dict.fromkeys(Units, 0)


def run(*command):
    result = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}:\n{result.stderr}")
    return result.stderr


def rtl_cycles(ffgpu, trace, frames, latency):
    """The Verilated pipe's, by the draw's number."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "rtl.csv"
        run(ffgpu, "replay", trace, "--rtl", "fragment_pipe", "--frames", frames, "--no-images",
            "--rtl-cycles", file, "--rtl-latency", latency)
        with open(file) as lines:
            return {int(row["draw"]): Cycles(int(row["cycles"]),
                                             {u: int(row[u + "_busy"]) for u in Units})
                    for row in csv.DictReader(lines)}


def model_cycles(ffgpu, trace, frames, settings):
    """The machine's: from the cycle in which the rasterizer takes a draw's first primitive to the last
    in which a unit is not idle."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "model.json"
        command = [ffgpu, "export", trace, "--format", "perfetto", "--frames", frames, "-o", file,
                   "--config", *settings[:1]]
        run(*command, *(["--set", *settings[1:]] if settings[1:] else []))
        with open(file) as lines:
            return charge(*spans_and_draws(lines))


def spans_and_draws(lines):
    names, spans, draws = {}, [], []
    for line in lines:
        if found := Name.search(line):
            names[int(found[1])] = found[2]
        elif found := Span.search(line):
            begin, length, process, track = map(int, found.groups()[1:])
            if process == 1 and names[track] in Units:
                spans.append((begin, begin + length, names[track], found[1] == "busy"))
            elif process == 2 and track == 1:
                draws.append((begin, begin + length, found[1]))
    return sorted(spans), draws


def charge(spans, commands):
    """Spans to the commands in whose cycles they begin."""
    result, at = {}, 0
    for begin, end, name in commands:
        kind, number = name.split()
        first = last = None
        cycles = Cycles()
        while at < len(spans) and spans[at][0] < end:
            span_begin, span_end, unit, busy = spans[at]
            at += 1
            if first is None and unit != "raster":
                continue
            first = span_begin if first is None else first
            last = max(last or 0, span_end)
            if busy:
                cycles.busy[unit] += span_end - span_begin
        if kind == "draw" and first is not None:
            cycles.total = last - first
            result[int(number)] = cycles
    return result


def off(model, rtl):
    return model / rtl - 1 if rtl else float(model != 0)


def table(name, model, rtl):
    """Prints one; whether it holds."""
    both = sorted(set(model) & set(rtl))
    if not both:
        sys.exit(f"{name}: no draw of these frames went through the pipe")
    sums = [Cycles(), Cycles()]
    for side, draws in zip(sums, (model, rtl)):
        for draw in both:
            side.total += draws[draw].total
            for unit in Units:
                side.busy[unit] += draws[draw].busy[unit]
    agree = sum(abs(off(model[d].total, rtl[d].total)) <= Draw for d in both)
    total = off(sums[0].total, sums[1].total)
    holds = abs(total) <= Total and agree >= 0.95 * len(both)
    print(f"{name}: {len(both)} draws, model {sums[0].total}, RTL {sums[1].total} cycles "
          f"({100 * total:+.2f} %); {agree} draws ({100 * agree / len(both):.1f} %) within 10 %")
    for unit in Units:
        model_busy, rtl_busy = sums[0].busy[unit], sums[1].busy[unit]
        difference = off(model_busy, rtl_busy)
        holds = holds and abs(difference) <= Unit
        print(f"  {unit:13} busy {model_busy:10} {rtl_busy:10} {100 * difference:+7.2f} %")
    return holds


# What is tried of the pipe: parameters of fragment_pipe, settings of the machine, and the memory's
# latency; the RTL's are its own where nothing is said. Two that follow each other are compared.
Variants = {
    "texel cache of 32 lines": ({"SetBits": 3}, ["texel_cache.sets=8"], 20),
    "64 lines": ({}, [], 20),
    "128 lines": ({"SetBits": 5}, ["texel_cache.sets=32"], 20),
    "texel queue of 8": ({"QueueDepth": 8}, ["texture.texel_queue=8"], 20),
    "texel queue of 32": ({}, [], 20),
    "8 quads at a target": ({"TargetQuads": 8}, ["depth_cache.fragment_fifo=8",
                                                 "color_cache.fragment_fifo=8"], 20),
    "16 quads at a target": ({}, [], 20),
    "a memory of 20 cycles": ({}, [], 20),
    "a memory of 100 cycles": ({}, [], 100),
}
Comparisons = [("texel cache of 32 lines", "64 lines"), ("64 lines", "128 lines"),
               ("texel queue of 8", "texel queue of 32"),
               ("8 quads at a target", "16 quads at a target"),
               ("a memory of 20 cycles", "a memory of 100 cycles")]


def is_current(pipe):
    """It was built of the sources as they are."""
    sources = [file for pattern in ("*.sv", "pipe/*", "bundles/*")
               for file in (Root / "rtl").glob(pattern)]
    return pipe.exists() and pipe.stat().st_mtime > max(f.stat().st_mtime for f in sources)


def tree_of(build, parameters):
    """The build's, or one with a pipe of other parameters."""
    if not parameters:
        return build
    folder = build / "rtl_cycles" / "_".join(f"{name}{value}" for name, value in parameters.items())
    if not is_current(folder / "driver/GL/ffgpu_pipe.so"):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        build_tree(folder, build, options=[f"-G{n}={v}" for n, v in parameters.items()])
    shutil.copy(build / "tools/ffgpu", folder / "tools/ffgpu")
    return folder


def sum_of_both(model, rtl):
    both = set(model) & set(rtl)
    return sum(model[d].total for d in both), sum(rtl[d].total for d in both)


def trends(build, trace, frames, config):
    """Prints a table of totals; whether model and RTL agree in each sign."""
    totals = {}
    for name, (parameters, settings, latency) in Variants.items():
        tree = tree_of(build, parameters)
        rtl = rtl_cycles(tree / "tools/ffgpu", trace, frames, latency)
        model = model_cycles(build / "tools/ffgpu", trace, frames,
                             [config, f"memory.latency={latency}", *settings])
        totals[name] = sum_of_both(model, rtl)
    holds = True
    for first, second in Comparisons:
        (model, rtl), (then_model, then_rtl) = totals[first], totals[second]
        agrees = (then_model > model) - (then_model < model) == (then_rtl > rtl) - (then_rtl < rtl)
        holds = holds and agrees
        print(f"  {first} -> {second}: model {model} -> {then_model} "
              f"({100 * off(then_model, model):+.2f} %), RTL {rtl} -> {then_rtl} "
              f"({100 * off(then_rtl, rtl):+.2f} %){'' if agrees else ': SIGNS PART'}")
    return holds


def path_of(trace):
    for folder in (Root / "traces", Root.parent / "shared/workloads/traces"):
        if (folder / f"{trace}.trace").exists():
            return folder / f"{trace}.trace"
    return Path(trace)


def those_there():
    """Of the ten traces some are recordings that may not stand beside the sources."""
    there = [trace for trace in Traces if path_of(trace).exists()]
    if missing := [trace for trace in Traces if trace not in there]:
        print(f"not here, left out: {', '.join(missing)}")
    return there


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--frames")
    parser.add_argument("--config", default="preset:rtl_pipe")
    parser.add_argument("--latency", default="20")
    parser.add_argument("--trends", action="store_true")
    parser.add_argument("--draws", type=int, default=0, help="list so many that differ most")
    parser.add_argument("traces", nargs="*")
    arguments = parser.parse_intermixed_args()
    ffgpu = arguments.build / "tools/ffgpu"
    holds = True
    for trace in arguments.traces or those_there():
        frames = arguments.frames or OnlyFrame.get(trace, "1-1")
        rtl = rtl_cycles(ffgpu, path_of(trace), frames, arguments.latency)
        model = model_cycles(ffgpu, path_of(trace), frames,
                             [arguments.config, f"memory.latency={arguments.latency}"])
        holds = table(Path(trace).stem, model, rtl) and holds
        if arguments.trends:
            holds = trends(arguments.build, path_of(trace), frames,
                           arguments.config) and holds
        both = sorted(set(model) & set(rtl), key=lambda d: -abs(off(model[d].total, rtl[d].total)))
        for draw in both[:arguments.draws]:
            print(f"    draw {draw}: model {model[draw].total} {model[draw].busy}\n"
                  f"    {' ' * 5} {' ' * len(str(draw))}  RTL {rtl[draw].total} {rtl[draw].busy}")
    sys.exit(0 if holds else 1)


if __name__ == "__main__":
    main()
