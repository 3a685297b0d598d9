#!/usr/bin/env python3
"""Speed of ffgpu beside Mesa's softpipe and llvmpipe, measured in one run and printed as ratios.

    tests/benchmarks/bench.py --build build [--workloads DIR] [--threads N]
                              [--only traces|rates|live|recording|start]

Traces: frames a second of the last frame repeated, by `ffgpu replay --benchmark` and by `glretrace
--benchmark`, without start-up and without pictures; the same with nothing drawn, which is what player and driver cost by
themselves (`--player-only`); and of the whole with the timing model. Rates: fill
and vertex rates of one program (gl_rates) on ffgpu's off-screen library and on Mesa's. Mesa runs with
LP_NUM_THREADS=0, that is on one thread, where ffgpu does; then all is measured in processor time.
Live: frames a second of programs in their windows. Recording: what it costs to save the work. Start: time and memory
of `ffgpu --help`, memory of replays (bench_programs.py).
"""
import argparse
import contextlib
import glob
import os
import re
import statistics
import subprocess
import sys
import time

from bench_programs import bench_live, bench_recording, bench_start

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PEERS = ("softpipe", "llvmpipe")
OSMESA = ("/usr/lib/x86_64-linux-gnu/libOSMesa.so.8", "/usr/lib/aarch64-linux-gnu/libOSMesa.so.8")
# One thread's work costs the same time of the processor on a busy machine; that of several is wanted
# sooner, not cheaper.
CLOCK = {True: "processor", False: "wall"}


def mesa_environment(driver, threads):
    return dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER=driver, vblank_mode="0",
                LP_NUM_THREADS="0" if threads == 1 else str(threads), MESA_SHADER_CACHE_DISABLE="1")


def seconds_of(command, environment, threads):
    """Of the processor for one thread, of the wall's clock for several; None where it fails."""
    begin = time.monotonic()
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        return None
    return usage.ru_utime + usage.ru_stime if threads == 1 else time.monotonic() - begin


@contextlib.contextmanager
def x_server():
    """The number of a virtual X server, which Mesa's drivers need for a context."""
    reader, writer = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
                              pass_fds=[writer], stderr=subprocess.DEVNULL)
    os.close(writer)
    try:
        with os.fdopen(reader) as number:
            yield ":" + number.readline().strip()
    finally:
        server.terminate()
        server.wait()


class Player:
    """Something that draws a trace's last frame again and again."""

    def __init__(self, name, command, environment, threads):
        self.name, self.environment, self.threads = name, environment, threads
        self.command = command  # of a number of repetitions

    def seconds(self, loops):
        return seconds_of(self.command(loops), self.environment, self.threads)

    def enough_loops(self):
        """So many that they take about a second, and what comes before them. None where a player repeats
        nothing: one that finds no end of a frame in the trace."""
        start, loops = self.seconds(1), 4
        while start is not None and loops < 2_000_000:
            spent = self.seconds(loops + 1)
            if spent is None or spent - start > 0.25:
                return spent and max(loops, round(loops / (spent - start)))
            loops *= 5
        return None

    def rate(self, loops):
        """Frames a second; what compiles, uploads and starts is behind."""
        short, long = self.seconds(1), self.seconds(loops + 1)
        return loops / (long - short) if short and long and long - short > 0.2 else None


def players(options, display, trace):
    def ours(loops):
        return [options.ffgpu, "replay", trace, "--threads", str(options.threads), "--benchmark", str(loops)]

    def mesas(loops):
        return ["glretrace", "--headless", "--benchmark", f"--loop={loops}", trace]

    def our_player(loops):
        return [*ours(loops), "--player-only"]

    yield Player("ffgpu", ours, None, options.threads)
    yield Player("player", our_player, None, options.threads)
    for peer in PEERS:
        environment = dict(mesa_environment(peer, options.threads), DISPLAY=display)
        yield Player(peer, mesas, environment, options.threads)


def timing_rates(options, trace):
    """Frames a second over the whole trace with the machine in time, and million cycles a second."""
    command = [options.ffgpu, "replay", trace, "--threads", str(options.threads), "--timing", "--benchmark", "1"]
    out = subprocess.run(command, capture_output=True, text=True)
    rate = re.search(r"([\d.]+) frames/s over (\d+) frames", out.stderr)
    cycles = re.search(r"(\d+) cycles", out.stderr)
    if not rate or not cycles:
        print(out.stderr.strip(), file=sys.stderr)
        return None, None
    seconds = int(rate[2]) / float(rate[1])
    return float(rate[1]), int(cycles[1]) / seconds * 1e-6


def cell(value):
    return f"{value:9.1f}" if value else "        -"


def middle(rates):
    rates = [rate for rate in rates if rate]
    return statistics.median(rates) if rates else None


def frame_rates(options, display, trace):
    """Lists of the rounds' rates by player."""
    loops = {player: player.enough_loops() for player in players(options, display, trace)}
    rates = {player.name: [] for player in loops}
    for _ in range(options.rounds):
        for player, count in loops.items():
            rates[player.name].append(player.rate(count) if count else None)
    return rates


def find_traces(options):
    """Those of real programs, or where there are none, the project's own."""
    traces = sorted(glob.glob(os.path.join(options.workloads, "traces", "*.trace")))
    return traces or sorted(glob.glob(os.path.join(ROOT, "traces", "*.trace")))


def bench_traces(options, display):
    traces = find_traces(options)
    print(f"Frames a second of the last frame repeated, {options.threads} thread(s), {CLOCK[options.threads == 1]} time,")
    print(f"middle of {options.rounds} rounds in which each takes its turn. Ratios: least, middle, greatest of the rounds.")
    print("player: ffgpu's player and driver alone, nothing drawn; its share of the frame's time.")
    print("timing: frames a second over the whole trace with the timing model, and million cycles a second.")
    print(f"{'trace':16s}" + "".join(f"{name:>9s}" for name in ("ffgpu", "player", *PEERS)) + f"{'share':>7s}"
          + "".join(f"{'/ ' + peer:>22s}" for peer in PEERS) + f"{'timing':>9s} Mcycles/s")
    medians = {peer: [] for peer in PEERS}
    speeds = []
    for trace in traces:
        found = frame_rates(options, display, trace)
        timed, cycles = timing_rates(options, trace)
        row = "".join(cell(middle(found[name])) for name in found)
        row += f"{share(middle(found['ffgpu']), middle(found['player'])):>7s}"
        for peer in PEERS:
            ratios = [a / b for a, b in zip(found["ffgpu"], found[peer]) if a and b]
            row += spread(ratios)
            if ratios:
                medians[peer].append(statistics.median(ratios))
        if cycles:
            speeds.append(cycles)
        print(f"{os.path.basename(trace)[:-6]:16s}{row}{cell(timed)} {cell(cycles)}", flush=True)
    print_medians(medians)
    if speeds:
        print(f"median: {statistics.median(speeds):.2f} million cycles a second with timing")


def share(whole, part):
    """Of a frame's time that the player takes."""
    return f"{whole / part:.0%}" if whole and part else "-"


def spread(ratios):
    """Least, middle and greatest."""
    if not ratios:
        return f"{'-':>22s}"
    return f"{min(ratios):6.2f} {statistics.median(ratios):6.2f}x{max(ratios):7.2f} "


def print_medians(medians):
    for peer, ratios in medians.items():
        if ratios:
            print(f"median {statistics.median(ratios):.2f} x {peer}, least {min(ratios):.2f} x")


def rates(library, environment, clock):
    """Million a second by (case, unit)."""
    out = subprocess.run([ARGUMENTS.gl_rates, library, "0.15", clock], env=environment, capture_output=True, text=True)
    if out.returncode:
        print(out.stderr.strip(), file=sys.stderr)
    rows = (line.split("\t") for line in out.stdout.splitlines())
    return {(case, unit): float(rate) for case, unit, rate in rows}


def bench_rates(options):
    ours = (os.path.join(options.build, "driver", "OSMesa", "libOSMesa.so.8"),
            dict(os.environ, FFGPU_THREADS=str(options.threads)))
    libraries = {"ffgpu": ours}
    mesa = next((path for path in OSMESA if os.path.exists(path)), None)
    if mesa:
        libraries.update({peer: (mesa, mesa_environment(peer, options.threads)) for peer in PEERS})
    clock = CLOCK[options.threads == 1]
    rounds = [{name: rates(*library, clock) for name, library in libraries.items()} for _ in range(options.rounds)]
    print(f"\nRates through an off-screen context, 640x480, {options.threads} thread(s), {clock} time; million a second,")
    print(f"best of {options.rounds} rounds in which each takes its turn. Ratios: least, middle, greatest of the rounds.")
    print(f"{'case':34s} {'unit':9s}" + "".join(f"{name:>9s}" for name in libraries)
          + "".join(f"{'/ ' + peer:>22s}" for peer in PEERS))
    medians = {peer: [] for peer in PEERS}
    for case in rounds[0]["ffgpu"]:
        cells = "".join(f"{max(r[name].get(case, 0) for r in rounds):9.1f}" for name in libraries)
        for peer in PEERS:
            ratios = [r["ffgpu"][case] / r[peer][case] for r in rounds if peer in r and r[peer].get(case)]
            cells += spread(ratios)
            if ratios:
                medians[peer].append(statistics.median(ratios))
        print(f"{case[0]:34s} {case[1]:9s}{cells}")
    print_medians(medians)


def main():
    global ARGUMENTS
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build"))
    parser.add_argument("--workloads", default=os.environ.get("FFGPU_WORKLOADS", os.path.join(ROOT, "..", "shared", "workloads")))
    parser.add_argument("--only", choices=("traces", "rates", "live", "recording", "start"))
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--rounds", type=int, default=5, help="in which each takes its turn")
    ARGUMENTS = parser.parse_args()
    ARGUMENTS.gl_rates = os.path.join(ARGUMENTS.build, "tests", "benchmarks", "gl_rates")
    ARGUMENTS.ffgpu = os.path.join(ARGUMENTS.build, "tools", "ffgpu")
    print(time.strftime("%Y-%m-%d"), os.uname().machine, f"{os.cpu_count()} cores")
    wanted = [ARGUMENTS.only] if ARGUMENTS.only else ["traces", "rates", "live", "recording", "start"]
    with x_server() as display:
        if "traces" in wanted:
            bench_traces(ARGUMENTS, display)
        if "rates" in wanted:
            bench_rates(ARGUMENTS)
        if "live" in wanted:
            bench_live(ARGUMENTS, display, mesa_environment, cell, spread)
        if "recording" in wanted:
            bench_recording(ARGUMENTS, find_traces(ARGUMENTS))
        if "start" in wanted:
            bench_start(ARGUMENTS, find_traces(ARGUMENTS))


main()
