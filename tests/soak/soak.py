#!/usr/bin/python3
"""Long and rough runs of live programs under `ffgpu run`: ./dev soak, docs/security.md.

It also has to see leaks that are there on purpose.

    tests/soak/soak.py --build BUILD [--frames 10000] [--clients 50] [--kills 100] [--seed 1]
                       [--part NAME ...]

Wants Xvfb, xrestop and glxgears. Exit status 0: nothing grew, was lost, or hung.
"""

import argparse
import hashlib
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from x_server import XServer

# What the program's resident memory may grow by between a tenth of the frames and the last.
MOST_GROWTH_KIB = 2048
# A program that is told to end, or loses its server, has so long.
PATIENCE_SECONDS = 60


class Soak:
    def __init__(self, options, folder):
        self.options = options
        self.build = pathlib.Path(options.build).resolve()
        self.folder = folder
        self.failed = False

    def check(self, holds, claim):
        print(f"  {'ok    ' if holds else 'FAILED'}  {claim}", flush=True)
        self.failed = self.failed or not holds

    def run(self, server, frames, out, *program):
        """A program under `ffgpu run`; what it says goes to OUT.log."""
        out = self.folder / out
        with open(f"{out}.log", "w") as log:
            return subprocess.Popen(
                [self.build / "tools/ffgpu", "run", "-o", out, "--frames", f"0-{frames - 1}", "--",
                 *program], env=server.environment, stdout=log, stderr=log)

    def frames_program(self):
        return [self.build / "tests/frames", "endless"]


def children_of(process):
    path = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
    return [int(word) for word in path.read_text().split()]


def figures_of(pid, server):
    """Resident KiB, open descriptors, threads, and the X resources of the one client."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text()
    lines = dict(line.split(":", 1) for line in status.splitlines())
    return {"resident KiB": int(lines["VmRSS"].split()[0]),
            "descriptors": len(os.listdir(f"/proc/{pid}/fd")), "threads": int(lines["Threads"]),
            **{key: value for key, value in server.clients()[0].items() if key != "name"}}


def wait_for(path, process):
    while not path.exists():
        if process.poll() is not None:
            raise SystemExit(f"soak: the program ended before {path.name}")
        time.sleep(0.05)


def ended(process):
    """The exit status; None, and killed: it hung."""
    try:
        return process.wait(PATIENCE_SECONDS)
    except subprocess.TimeoutExpired:
        for child in children_of(process):
            os.kill(child, signal.SIGKILL)
        process.kill()
        process.wait()
        return None


def alive(pids):
    return [pid for pid in pids if os.path.exists(f"/proc/{pid}") and
            "Z" != pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]]


def sampled(soak, out, *program):
    """Runs a program and ends it: its figures at a tenth of the frames and at the last of them, and
    whether it ended."""
    frames = soak.options.frames
    with XServer() as server:
        # More than are waited for, so that the program is still there when the last is looked at.
        process = soak.run(server, 2 * frames, out, *program)
        pid, samples = None, []
        for frame in (frames // 10, frames):
            wait_for(soak.folder / out / f"frame_{frame - 1:04}.png", process)
            pid = pid or children_of(process)[0]
            samples.append(figures_of(pid, server))
        os.kill(process.pid, signal.SIGINT)
        return *samples, ended(process) is not None


def grown(first, last):
    """The figures that grew by more than they may."""
    return [key for key in first
            if last[key] > first[key] + (MOST_GROWTH_KIB if key == "resident KiB" else 0)]


def long_run(soak):
    frames = soak.options.frames
    print(f"{frames} frames of glxgears, every one recorded", flush=True)
    first, last, has_ended = sampled(soak, "long", "glxgears")
    soak.check(has_ended, "ended when it was interrupted")
    for key in first:
        soak.check(key not in grown(first, last),
                   f"{key}: {first[key]} at frame {frames // 10}, {last[key]} at {frames}")


def leaks(soak):
    """Whether long_run() sees what a program loses on purpose, and names it."""
    print(f"leaks on purpose, {soak.options.frames} frames each", flush=True)
    for what, key in (("memory", "resident KiB"), ("descriptor", "descriptors"),
                      ("pixmap", "pixmaps")):
        first, last, _ = sampled(soak, what, soak.build / "tests/frames", "leak", what)
        names = grown(first, last)
        figures = ", ".join(f"{name}: {first[name]} to {last[name]}" for name in names)
        soak.check(key in names, f"{what}: {figures or 'not seen'}")


def pictures_of(folder, count):
    return [hashlib.sha256((folder / f"frame_{frame:04}.png").read_bytes()).hexdigest()
            for frame in range(count)]


def crowd(soak):
    count, frames = soak.options.clients, 20
    print(f"{count} clients at once on one X server, {frames} frames each", flush=True)
    with XServer() as server:
        processes = [soak.run(server, frames, f"crowd{i}", *soak.frames_program())
                     for i in range(count)]
        statuses = [ended(process) for process in processes]
        soak.check(statuses == [0] * count, f"exit statuses: {sorted(set(statuses), key=str)}")
        pictures = [pictures_of(soak.folder / f"crowd{i}", frames) for i in range(count)]
        soak.check(len(set(pictures[0])) == 10 and all(p == pictures[0] for p in pictures),
                   "each drew the same pictures, ten different ones")
        soak.check(server.wait_for_clients(0), "the server has no client left")


def kills(soak):
    count = soak.options.kills
    print(f"{count} clients killed while they swap, beside one that goes on", flush=True)
    choose = random.Random(soak.options.seed)
    with XServer() as server:
        beside = soak.run(server, 10**6, "beside", *soak.frames_program())
        wait_for(soak.folder / "beside/frame_0000.png", beside)
        statuses, killed = set(), set()
        for i in range(count):
            process = soak.run(server, 10**6, "killed", *soak.frames_program())
            wait_for(soak.folder / "killed/frame_0000.png", process)
            # A server that stands still holds the program inside of its swap; else anywhere.
            if i % 2 == 0:
                server.process.send_signal(signal.SIGSTOP)
            time.sleep(choose.uniform(0.005, 0.05))
            program = children_of(process)[0]
            os.kill(program, signal.SIGKILL)
            killed.add(program)
            server.process.send_signal(signal.SIGCONT)
            statuses.add(ended(process))
            for picture in (soak.folder / "killed").glob("*"):
                picture.unlink()
        soak.check(statuses == {128 + signal.SIGKILL}, f"exit statuses of ffgpu: {statuses}")
        soak.check(server.wait_for_clients(1), "the server has the other client alone left")
        lost = [segment for segment in segments() if segment["creator"] in killed]
        soak.check(not lost, f"segments of shared memory that the killed left: {lost}")
        number = len(list((soak.folder / "beside").glob("*.png")))
        wait_for(soak.folder / f"beside/frame_{number + 20:04}.png", beside)
        os.kill(beside.pid, signal.SIGINT)
        soak.check(ended(beside) is not None, "the other client still drew, and ended")


def segments():
    """Those of System V shared memory on this machine, whoever made them."""
    rows = pathlib.Path("/proc/sysvipc/shm").read_text().splitlines()[1:]
    return [{"id": int(row.split()[1]), "creator": int(row.split()[4])} for row in rows]


def server_gone(soak):
    print("the X server is killed", flush=True)
    for name, program in (("glxgears", ["glxgears"]), ("frames", soak.frames_program())):
        server = XServer()
        process = soak.run(server, 10**6, f"gone_{name}", *program)
        wait_for(soak.folder / f"gone_{name}/frame_0009.png", process)
        family = [process.pid, *children_of(process)]
        server.kill()
        status = ended(process)
        log = (soak.folder / f"gone_{name}.log").read_text()
        soak.check(status not in (None, 0), f"{name}: ended with status {status}")
        soak.check("X connection to" in log or "fatal IO error" in log, f"{name}: Xlib's message")
        soak.check(not alive(family), f"{name}: no process is left")
        soak.check((soak.folder / f"gone_{name}/stats.json").exists(), f"{name}: has statistics")


PARTS = {part.__name__: part for part in (long_run, leaks, crowd, kills, server_gone)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default="build")
    parser.add_argument("--frames", type=int, default=10_000)
    parser.add_argument("--clients", type=int, default=50)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--part", action="append", choices=PARTS, help="this one only")
    options = parser.parse_args()
    # A shell's background job ignores SIGINT, and so would the programs that are interrupted here.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with tempfile.TemporaryDirectory() as folder:
        soak = Soak(options, pathlib.Path(folder))
        for name in options.part or PARTS:
            PARTS[name](soak)
    sys.exit(soak.failed)


main()
