#!/usr/bin/env python3
"""Speed of ffgpu beside Mesa's softpipe and llvmpipe, measured in one run and printed as ratios.

    tests/benchmarks/bench.py --build build [--workloads DIR] [--only traces|rates] [--threads N]

Traces: frames a second of `ffgpu replay` (functional, and with the timing model) against
`glretrace --benchmark`, the last frame repeated. Rates: fill and vertex rates of one program
(gl_rates) on ffgpu's off-screen library and on Mesa's. Mesa runs with LP_NUM_THREADS=0, that is on
one thread, where ffgpu does. Machines are shared: each figure is the best of a few runs.
"""
import argparse
import glob
import os
import re
import statistics
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PEERS = ("softpipe", "llvmpipe")
OSMESA = ("/usr/lib/x86_64-linux-gnu/libOSMesa.so.8", "/usr/lib/aarch64-linux-gnu/libOSMesa.so.8")
RUNS = 3
LOOPS = 10  # repetitions of a trace's last frame


def mesa_environment(driver, threads):
    return dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER=driver, vblank_mode="0",
                LP_NUM_THREADS="0" if threads == 1 else str(threads), MESA_SHADER_CACHE_DISABLE="1")


def best(measure):
    rates = [measure() for _ in range(RUNS)]
    return max((r for r in rates if r), default=None)


def glretrace_seconds(trace, driver, threads, loops):
    out = subprocess.run(["xvfb-run", "-a", "glretrace", "--headless", "--benchmark", f"--loop={loops}", trace],
                         env=mesa_environment(driver, threads), capture_output=True, text=True)
    found = re.search(r"in ([\d.]+) secs", out.stdout + out.stderr)
    return float(found[1]) if found else None


def glretrace_rate(trace, driver, threads):
    """Frames a second of the last frame, repeated: compilers and texture uploads are behind."""
    short, long = (glretrace_seconds(trace, driver, threads, loops) for loops in (LOOPS, 3 * LOOPS))
    return 2 * LOOPS / (long - short) if short and long and long > short else None


def ffgpu_run(binary, trace, threads, timing):
    command = [binary, "replay", trace, "--threads", str(threads)] + (["--timing"] if timing else [])
    command += ["--benchmark", "1" if timing else str(2 * LOOPS)]
    out = subprocess.run(command, capture_output=True, text=True)
    if out.returncode:
        print(out.stderr.strip(), file=sys.stderr)
    return out.stdout + out.stderr


def ffgpu_rate(binary, trace, threads):
    found = re.search(r"([\d.]+) frames/s, .* over the last frame", ffgpu_run(binary, trace, threads, False))
    return float(found[1]) if found else None


def timing_rates(binary, trace, threads):
    """Frames a second over the whole trace, and million cycles a second."""
    text = ffgpu_run(binary, trace, threads, True)
    rate = re.search(r"([\d.]+) frames/s over (\d+) frames", text)
    cycles = re.search(r"(\d+) cycles", text)
    if not rate or not cycles:
        return None, None
    seconds = int(rate[2]) / float(rate[1])
    return float(rate[1]), int(cycles[1]) / seconds * 1e-6


def ratio(a, b):
    return f"{a / b:7.2f}x" if a and b else "      - "


def bench_traces(options):
    binary = os.path.join(options.build, "tools", "ffgpu")
    traces = sorted(glob.glob(os.path.join(options.workloads, "traces", "*.trace")))
    if not traces:  # Without those of real programs, the project's own.
        traces = sorted(glob.glob(os.path.join(ROOT, "traces", "*.trace")))
    print(f"Frames a second of the last frame repeated, {options.threads} thread(s); ratios are ffgpu / peer.")
    print("timing: frames a second over the whole trace with the timing model, and its speed.")
    print(f"{'trace':16s} {'ffgpu':>9s} {'softpipe':>9s} {'llvmpipe':>9s}   /softpipe  /llvmpipe {'timing':>9s}  Mcycles/s")
    columns = {peer: [] for peer in PEERS}
    speeds = []
    for trace in traces:
        ours = best(lambda: ffgpu_rate(binary, trace, options.threads))
        timed, cycles = timing_rates(binary, trace, options.threads)
        peers = {peer: best(lambda: glretrace_rate(trace, peer, options.threads)) for peer in PEERS}
        for peer in PEERS:
            if ours and peers[peer]:
                columns[peer].append(ours / peers[peer])
        if cycles:
            speeds.append(cycles)
        cell = lambda value: f"{value:9.1f}" if value else "        -"
        print(f"{os.path.basename(trace)[:-6]:16s} {cell(ours)} {cell(peers['softpipe'])} {cell(peers['llvmpipe'])}   "
              f"{ratio(ours, peers['softpipe'])}   {ratio(ours, peers['llvmpipe'])} {cell(timed)}  {cell(cycles)}", flush=True)
    for peer in PEERS:
        if columns[peer]:
            print(f"median: {statistics.median(columns[peer]):.2f} x {peer}")
    if speeds:
        print(f"median: {statistics.median(speeds):.2f} million cycles a second with timing")


def rates(library, environment):
    program = ARGUMENTS.gl_rates
    out = subprocess.run([program, library, "0.5"], env=environment, capture_output=True, text=True)
    if out.returncode:
        print(out.stderr.strip(), file=sys.stderr)
    return {row[0]: (row[1], float(row[2])) for row in (line.split("\t") for line in out.stdout.splitlines())}


def bench_rates(options):
    ours = rates(os.path.join(options.build, "driver", "OSMesa", "libOSMesa.so.8"), dict(os.environ, FFGPU_THREADS=str(options.threads)))
    mesa = next((path for path in OSMESA if os.path.exists(path)), None)
    peers = {peer: rates(mesa, mesa_environment(peer, options.threads)) if mesa else {} for peer in PEERS}
    print(f"\nRates through an off-screen context, 640x480, {options.threads} thread(s); million a second")
    print(f"{'case':34s} {'unit':9s} {'ffgpu':>8s} {'softpipe':>9s} {'llvmpipe':>9s}   /softpipe  /llvmpipe")
    for case, (unit, rate) in ours.items():
        soft, llvm = (peers[peer].get(case, (unit, None))[1] for peer in PEERS)
        cell = lambda value: f"{value:9.1f}" if value else "        -"
        print(f"{case:34s} {unit:9s} {rate:8.1f} {cell(soft)} {cell(llvm)}   {ratio(rate, soft)}   {ratio(rate, llvm)}")


def main():
    global ARGUMENTS
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build"))
    parser.add_argument("--workloads", default=os.environ.get("FFGPU_WORKLOADS", os.path.join(ROOT, "..", "shared", "workloads")))
    parser.add_argument("--only", choices=("traces", "rates"))
    parser.add_argument("--threads", type=int, default=1)
    ARGUMENTS = parser.parse_args()
    ARGUMENTS.gl_rates = os.path.join(ARGUMENTS.build, "tests", "benchmarks", "gl_rates")
    print(time.strftime("%Y-%m-%d"), os.uname().machine, f"{os.cpu_count()} cores")
    if ARGUMENTS.only != "rates":
        bench_traces(ARGUMENTS)
    if ARGUMENTS.only != "traces":
        bench_rates(ARGUMENTS)


main()
