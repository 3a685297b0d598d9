#!/usr/bin/python3
"""Checks the DRAM commands that `ffgpu export --format dram_commands` tells against the rules of the
data sheets (JESD79 for DDR SDRAM: a command a cycle; tRCD, tRP, tRAS, tRRD, tFAW, tCCD, tRTP, tWR,
tWTR, tRFC, tREFI), and their sums against stats.json. Nothing of ffgpu's own is asked which command
may go out when. Each burst of the requests (--format csv) goes out once.

    dram_commands.py FFGPU TRACE...     random machines from a fixed seed, and the profiles
    --cases N --seed S                  as many, from another
"""

import argparse
import csv
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter, deque

NEVER = -(1 << 60)
COLUMNS = ("RD", "WR", "RDA", "WRA")


class Bank:
    def __init__(self):
        self.row = None
        self.activated = self.precharged = NEVER
        self.read = self.written = NEVER  # last read command; end of the last data written


class Channel:
    """One channel's commands, in the order of their cycles. `t`: the parameters of [memory]."""

    def __init__(self, t):
        self.t = t
        self.banks = [Bank() for _ in range(t["banks"])]
        self.last = NEVER  # command
        self.activates = deque(maxlen=4)
        self.column = NEVER
        self.data = (NEVER, False)  # the end of the last, and whether written
        self.refreshed = NEVER
        self.refreshes = []
        self.faults = Counter()
        self.counts = Counter()
        self.turns = 0
        self.examples = {}

    def expect(self, rule, holds, line):
        if not holds:
            self.faults[rule] += 1
            self.examples.setdefault(rule, line)

    def command(self, line):
        cycle, name = int(line["cycle"]), line["command"]
        self.counts[name] += 1
        self.expect("cycles rise", cycle >= self.last, line)
        self.expect("a command a cycle", cycle != self.last, line)
        self.last = cycle
        self.expect("tRFC", cycle >= self.refreshed + self.t["refresh_cycles"], line)
        if name == "REF":
            self.refresh(cycle, line)
        elif name == "PREA":
            for bank in self.banks:
                if bank.row is not None:
                    self.precharge(bank, cycle, line)
        elif name == "PRE":
            bank = self.banks[int(line["bank"])]
            self.expect("PRE of an open row", bank.row is not None, line)
            self.precharge(bank, cycle, line)
        elif name == "ACT":
            self.activate(self.banks[int(line["bank"])], cycle, line)
        else:
            self.access(self.banks[int(line["bank"])], cycle, line)

    def refresh(self, cycle, line):
        self.refreshes.append(cycle)
        self.refreshed = cycle
        for bank in self.banks:
            self.expect("REF with all rows closed", bank.row is None, line)
            self.expect("tRP to REF", cycle >= bank.precharged + self.t["precharge_cycles"], line)

    def row_may_close(self, bank):
        t = self.t
        return max(bank.activated + t["row_active_cycles"],
                   bank.read + t["read_to_precharge_cycles"],
                   bank.written + t["write_recovery_cycles"])

    def precharge(self, bank, cycle, line):
        t = self.t
        self.expect("tRAS", cycle >= bank.activated + t["row_active_cycles"], line)
        self.expect("tRTP", cycle >= bank.read + t["read_to_precharge_cycles"], line)
        self.expect("tWR", cycle >= bank.written + t["write_recovery_cycles"], line)
        bank.row = None
        bank.precharged = cycle

    def activate(self, bank, cycle, line):
        t = self.t
        self.expect("ACT of a closed bank", bank.row is None, line)
        self.expect("tRP", cycle >= bank.precharged + t["precharge_cycles"], line)
        if self.activates:
            self.expect("tRRD", cycle >= self.activates[-1] + t["activate_to_activate_cycles"], line)
        if len(self.activates) == 4 and t["four_activates_cycles"]:
            self.expect("tFAW", cycle >= self.activates[0] + t["four_activates_cycles"], line)
        self.activates.append(cycle)
        bank.row = line["row"]
        bank.activated = cycle
        bank.read = bank.written = NEVER

    def access(self, bank, cycle, line):
        t = self.t
        writes = line["command"].startswith("WR")
        self.expect("a column of the open row", bank.row == line["row"], line)
        self.expect("the row's bytes", int(line["byte"]) < t["row_bytes"], line)
        self.expect("tRCD", cycle >= bank.activated + t["row_to_column_cycles"], line)
        self.expect("tCCD", cycle >= self.column + t["column_to_column_cycles"], line)
        begin = cycle + (t["write_column_cycles"] if writes else t["column_cycles"])
        end = begin + t["burst_cycles"]
        before, was_written = self.data
        self.expect("one burst on the bus", begin >= before, line)
        self.turns += before > NEVER and writes != was_written
        if was_written and not writes:
            self.expect("tWTR", cycle >= before + t["write_to_read_cycles"], line)
        if writes and not was_written:
            self.expect("tRTW", begin >= before + t["read_to_write_cycles"], line)
        self.column = cycle
        self.data = (end, writes)
        if writes:
            bank.written = end
        else:
            bank.read = cycle
        if line["command"].endswith("A"):
            bank.precharged = self.row_may_close(bank)
            bank.row = None

    def check_refreshes(self, end):
        """None is left out, each is late by no more than what goes before it."""
        interval = self.t["refresh_interval_cycles"]
        if interval == 0:
            self.expect("no refresh", not self.refreshes, {})
            return
        for number, cycle in enumerate(self.refreshes, 1):
            line = {"cycle": cycle, "command": "REF"}
            self.expect("tREFI: not early", cycle >= number * interval, line)
            self.expect("tREFI: not late", cycle < (number + 1) * interval, line)
        self.expect("as many refreshes", abs(len(self.refreshes) - end // interval) <= 1, {})


def place(t, hashes, address):
    """Channel, bank, row and byte of an address, as docs/units/memory.md has them."""
    block, byte = divmod(address, t["interleave_bytes"])
    own = block // t["channels"] * t["interleave_bytes"] + byte
    number, byte = divmod(own, t["row_bytes"])
    bank = number % t["banks"]
    if hashes and t["banks"] > 1:
        bits, rest, bank = t["banks"].bit_length() - 1, number, 0
        while rest:
            bank ^= rest % t["banks"]
            rest >>= bits
    return block % t["channels"], bank, number // t["banks"], byte


def bursts_asked_for(t, hashes, path):
    """Of the requests that the machine's arbiter sends (--format csv)."""
    size = t["burst_cycles"] * t["bytes_per_cycle"]
    bursts = Counter()
    with open(path, newline="") as file:
        for line in csv.DictReader(file):
            channel, bank, row, byte = place(t, hashes, int(line["address"], 16))
            for begin in range(0, int(line["bytes"]), size):
                bursts[channel, bank, row, byte + begin, line["operation"] == "write"] += 1
    return bursts


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr}")
    return done


def memory_parameters(ffgpu, settings):
    """As the machine has them, from what `ffgpu config` prints."""
    text = run([ffgpu, "config", *settings]).stdout
    section = text.split("\n[memory]\n")[1].split("\n[")[0]
    return {name: int(value) for name, value in re.findall(r"^(\w+) = (\d+)", section, re.M)}


def check(ffgpu, trace, settings, folder):
    """Returns the faults, and an example of each."""
    t = memory_parameters(ffgpu, settings)
    path = folder / "commands.csv"
    run([ffgpu, "export", trace, "--format", "dram_commands", "-o", path, *settings])
    requests = folder / "requests.csv"
    run([ffgpu, "export", trace, "--format", "csv", "-o", requests, *settings])
    channels = [Channel(t) for _ in range(t["channels"])]
    carried = Counter()
    with open(path, newline="") as file:
        for line in csv.DictReader(file):
            channels[int(line["channel"])].command(line)
            if line["command"] in COLUMNS:
                carried[int(line["channel"]), int(line["bank"]), int(line["row"]),
                        int(line["byte"]), line["command"].startswith("WR")] += 1
    run([ffgpu, "replay", trace, "--timing", "-o", folder / "run", *settings])
    totals = json.loads((folder / "run/stats.json").read_text())["totals"]["timing"]
    end = totals["total_cycles"] * t["memory_clocks"] // t["core_clocks"]
    faults, examples, counts = Counter(), {}, Counter()
    for channel in channels:
        channel.check_refreshes(end)
        faults += channel.faults
        counts += channel.counts
        examples.update(channel.examples)
    columns = sum(counts[name] for name in COLUMNS)
    sums = {
        "refreshes": (counts["REF"], totals["memory_refreshes"]),
        "turnarounds": (sum(channel.turns for channel in channels), totals["memory_turnarounds"]),
        "cycles of bursts": (columns * t["burst_cycles"],
                             totals["memory_data_cycles"] + totals["memory_lost_burst_cycles"]),
    }
    asked = bursts_asked_for(t, "memory.bank_hash=xor" in settings, requests)
    if asked != carried:
        faults["each burst that is asked for, once"] += 1
        examples["each burst that is asked for, once"] = (
            list((asked - carried).items())[:2], list((carried - asked).items())[:2])
    # A row that is closed again before its request's turn is opened twice.
    misses = totals["memory_row_misses"] + totals["memory_row_conflicts"]
    if counts["ACT"] < misses:
        faults["an activate for each request that found no row"] += 1
    for name, (seen, told) in sums.items():
        if seen != told:
            faults[name] += 1
            examples[name] = (seen, told)
    return faults, examples, sum(counts.values())


def random_settings(random_):
    burst = random_.choice([1, 2, 4])
    memory = {
        "channels": random_.choice([1, 2, 4]),
        "banks": random_.choice([1, 2, 4, 8, 16]),
        "row_bytes": random_.choice([512, 1024, 2048]),
        "bytes_per_cycle": random_.choice([2, 4, 8, 16]),
        "queue": random_.choice([1, 2, 8, 16, 64, 100]),
        "scheduler": random_.choice(["first_ready", "in_order"]),
        "page_policy": random_.choice(["open", "closed", "timeout", "adaptive"]),
        "page_timeout_cycles": random_.randint(1, 200),
        "bank_hash": random_.choice(["modulo", "xor"]),
        "burst_cycles": burst,
        "column_to_column_cycles": random_.randint(1, 6),
        "row_to_column_cycles": random_.randint(0, 12),
        "column_cycles": random_.randint(0, 12),
        "write_column_cycles": random_.randint(0, 12),
        "precharge_cycles": random_.randint(0, 12),
        "row_active_cycles": random_.randint(0, 30),
        "activate_to_activate_cycles": random_.randint(0, 8),
        "four_activates_cycles": random_.choice([0, 0, random_.randint(1, 60)]),
        "read_to_precharge_cycles": random_.randint(0, 8),
        "write_recovery_cycles": random_.randint(0, 12),
        "write_to_read_cycles": random_.randint(0, 12),
        "read_to_write_cycles": random_.randint(0, 6),
        "refresh_interval_cycles": random_.choice([0, 1000, 2500]),
        "refresh_cycles": random_.randint(1, 60),
        "core_clocks": random_.choice([1, 1, 2, 3]),
        "memory_clocks": random_.choice([1, 1, 2, 3]),
    }
    return [word for name, value in memory.items() for word in ("--set", f"memory.{name}={value}")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("ffgpu")
    parser.add_argument("traces", nargs="+")
    parser.add_argument("--cases", type=int, default=4)
    parser.add_argument("--seed", type=int, default=2)
    arguments = parser.parse_args()
    random_ = random.Random(arguments.seed)
    machines = [["--set", f"memory.profile={profile}"] for profile in ("sdr", "ddr", "gddr3")]
    machines += [random_settings(random_) for _ in range(arguments.cases)]
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for number, settings in enumerate(machines):
            trace = arguments.traces[number % len(arguments.traces)]
            faults, examples, commands = check(arguments.ffgpu, trace, settings, pathlib.Path(folder))
            print(f"machine {number}, {pathlib.Path(trace).name}: {commands} commands,",
                  "all rules hold" if not faults else "broken:")
            for rule, count in faults.items():
                print(f"  {rule}: {count} times, first {examples[rule]}")
            if faults:
                print("  ", " ".join(settings))
            failed += bool(faults)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
