#!/usr/bin/env python3
"""cost.py [--check] [UNIT...]: what each RTL unit costs on an ECP5, by yosys, into docs/rtl_cost.md; and
of those that find room on an iCE40 what nextpnr-ice40 achieves (place.py), where it is installed.

--check: compares with the page, and fails where a figure is more than 3 % off. 77: no yosys.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import place
from ports import Packages, Rtl

Root = Rtl.parent
Page = Root / "docs" / "rtl_cost.md"
Tolerance = 0.03
# What is theirs alone is mapped, and the figures of the units inside are added: flattened they take
# hours. Those inside another one first.
Composed = ("interpolator", "shading_stages", "target_stages", "texture_unit", "fragment_pipe")
Shared = ("fifo", "skid_buffer")  # of any width: mapped where they stand
CacheSetBits = (3, 4, 5)
Columns = ("LUT", "flip-flops", "DSP", "memory bits", "longest path")


def units():
    """Every module with a clock, but the steps that are parts of one unit and count in it."""
    steps = re.compile(r".*_stage$|pipeline_register$|filter_axis$|tile_edge$")
    return sorted(p.stem for p in Rtl.glob("*.sv")
                  if "clk_i" in p.read_text() and not steps.match(p.stem))


def parts(unit):
    """The units that stand in a composed one, each with the pattern of its name in yosys."""
    if unit not in Composed:
        return {}
    text = (Rtl / f"{unit}.sv").read_text()
    found = {name: re.search(rf"^  {name} (#\()?", text, re.M)
             for name in units() if name != unit and name not in Shared}
    return {name: f"$paramod*\\{name}*" if match[1] else name
            for name, match in found.items() if match}


def cost(unit, parameters=None, known=None):
    """The five figures of a unit: of a design flattened and mapped, before placement. A composed one's
    parts are taken from those that are `known`."""
    files = " ".join(str(Rtl / f"{name}.sv") for name in [*Packages, unit])
    sets = "".join(f"-set {name} {value} " for name, value in (parameters or {}).items())
    boxes = parts(unit)
    boxing = "".join(f"blackbox {name}; " for name in boxes.values())
    cells = " ".join(f"t:{name}" for name in boxes.values())
    with tempfile.TemporaryDirectory() as scratch:
        script = (f"read_verilog -sv {files}; " + (f"chparam {sets} {unit}; " if sets else "") +
                  f"hierarchy -check -libdir {Rtl} -top {unit}; {boxing}synth_ecp5 -top {unit}; "
                  f"tee -q -o {scratch}/stat.json stat -json; "
                  f"delete t:TRELLIS_FF t:DP16KD t:TRELLIS_DPR16X4 {cells}; "
                  f"tee -q -o {scratch}/path ltp")
        subprocess.run(["yosys", "-q", "-p", script], check=True, stdout=subprocess.DEVNULL)
        told = json.loads(Path(scratch, "stat.json").read_text())
        design = told["modules"][f"\\{unit}"] if boxes else told["design"]
        path = Path(scratch, "path").read_text()
    figures = figures_of(design, path)
    for box, count in boxes_of(design, boxes).items():
        whole = known[box]
        figures = (*(f + count * w for f, w in zip(figures[:4], whole)), max(figures[4], whole[4]))
    print(unit, *(f"{name}={value}" for name, value in (parameters or {}).items()), *figures,
          flush=True)
    return figures


def boxes_of(design, boxes):
    """How many of each there are; one that is not there is a fault of ours."""
    counts = dict.fromkeys(boxes, 0)
    for cell, count in design["num_cells_by_type"].items():
        for box in boxes:
            if cell == box or (cell.startswith("$paramod") and box in cell.split("\\")):
                counts[box] += count
    if missing := [box for box, count in counts.items() if count == 0]:
        raise ValueError(f"not found: {', '.join(missing)}")
    return counts


def figures_of(design, path):
    cells = design["num_cells_by_type"]
    # A carry cell holds two LUTs, a cell of distributed memory 64 bits, a block 18432.
    luts = cells.get("LUT4", 0) + 2 * cells.get("CCU2C", 0)
    memory = (design["num_memory_bits"] + 64 * cells.get("TRELLIS_DPR16X4", 0) +
              18432 * cells.get("DP16KD", 0))
    longest = max([0, *(int(length) for length in re.findall(r"length=(\d+)", path))])
    return (luts, cells.get("TRELLIS_FF", 0), cells.get("MULT18X18D", 0), memory, longest)


def cache_memory(set_bits, way_bits=2, line_bits=6, fill_bits=3, queue_depth=32):
    """The memory bits of a texel cache by its parameters: memories of 16 words of 4 bits each."""
    def memory(words, width):
        return -(-words // 16) * -(-width // 4) * 64
    line, ways, number = 8 << line_bits, 1 << way_bits, 32 - line_bits
    place = set_bits + way_bits + line_bits - 4
    return (memory(ways << set_bits, line) + memory(1 << fill_bits, line) +
            memory(1 << set_bits, ways * (number - set_bits)) +
            memory(queue_depth, 11 + place + 1 + fill_bits))


def cache_table(measured):
    rows = "".join(f"| {1 << bits} | {4 << bits + 6} | {cache_memory(bits)} | {memory} |\n"
                   for bits, memory in sorted(measured.items()))
    return f"""## Sizes of the texel cache

Sets are a parameter, with four ways of lines of 64 bytes. The memory bits are as predicted from the parameters: lines, lines on their way, tags and the queue, each in memories of 16 words
of 4 bits.

| sets | bytes | memory bits, predicted | memory bits |
|---|---|---|---|
{rows}"""


def placed_table(placed):
    rows = "".join(f"| {unit} | {place.Chip} | {cells} | {frequency} |\n"
                   for unit, (cells, frequency) in sorted(placed.items()))
    return f"""## Placed and routed

By nextpnr-ice40 (Debian's 0.4, seed {place.Seed}) on the largest iCE40, of {place.Room} logic cells: a LUT of four inputs, a carry and a flop each, no multipliers. A unit stands between two shift registers,
since it has more ports than there are pins: every path lies between flops. Their cells are not counted. These are the units that it places within minutes.

| unit | chip | logic cells | MHz |
|---|---|---|---|
{rows}"""


def page(costs, cache, placed):
    version = subprocess.run(["yosys", "-V"], capture_output=True, text=True).stdout.split()[1]
    rows = "".join(f"| {unit} | " + " | ".join(str(f) for f in figures) + " |\n"
                   for unit, figures in sorted(costs.items()))
    left = [unit for unit in units() if unit not in costs]
    left = f"\nNot measured yet: {', '.join(left)}.\n" if left else ""
    return f"""# What the RTL costs

By `./dev rtl-cost`: each unit alone, with yosys {version} (`synth_ecp5`), flattened and mapped, before placement; of those of several units ({", ".join(sorted(Composed))})
what is their own, and the figures of the units inside added, with the longest path among them: more than one design would have, where a unit leaves an output open or ties an input.
A carry cell counts as two LUTs. The longest path is the number of cells on it between flops and memories, not a time: a carry chain of 24 bits is 12 cells
and fast.

| unit | {" | ".join(Columns)} |
|---|{"---|" * len(Columns)}
{rows}
Quads carry their key (96 bits) and, up to fog, eight units' samples (1024 bits) through every stage: that is most of the flip-flops of the environments. Data that a build never
looks at goes away with the ports that end it.
{left}
{cache_table(cache)}
{placed_table(placed)}"""


def read_page():
    """The figures of each unit on the page, the cache's memory bits by the bits of its sets, and those
    of units that are placed."""
    text = Page.read_text() if Page.exists() else ""
    rows = re.findall(r"^\| ([a-z]\w+) \| ([\d |]+) \|$", text, re.M)
    sizes = re.findall(r"^\| (\d+) \| \d+ \| \d+ \| (\d+) \|$", text, re.M)
    placed = re.findall(rf"^\| (\w+) \| {place.Chip} \| (\d+) \| ([\d.]+) \|$", text, re.M)
    return ({unit: tuple(int(f) for f in figures.split(" | ")) for unit, figures in rows},
            {int(sets).bit_length() - 1: int(memory) for sets, memory in sizes},
            {unit: (int(cells), float(frequency)) for unit, cells, frequency in placed})


def drifts_of(columns, before, now):
    """Between figures on the page and those of the units that were measured."""
    drifts = [f"{unit}: {column} was {old}, is {new}"
              for unit in now
              for column, old, new in zip(columns, before.get(unit, ()), now[unit])
              if abs(new - old) > Tolerance * old]
    drifts += [f"{unit}: not on the page" for unit in now if unit not in before]
    return drifts + [f"{unit}: on the page, not in rtl/" for unit in before if unit not in units()]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("units", nargs="*")
    arguments = parser.parse_args()
    if not shutil.which("yosys"):
        print("yosys is not installed: nothing is measured")
        sys.exit(77)
    names = arguments.units or units()
    before, cache, placed_before = read_page()
    placed = placed_units(names, arguments.jobs)
    costs = measured(names, before, cache, {**placed_before, **placed}, arguments)
    wrong = [f"texel_cache of {1 << bits} sets: {memory} memory bits, not {cache_memory(bits)}"
             for bits, memory in cache.items() if memory != cache_memory(bits)]
    drifts = (drifts_of(Columns, before, costs) + wrong +
              drifts_of(("logic cells", "MHz"), placed_before, placed))
    print(*(drifts if arguments.check else wrong), sep="\n")
    sys.exit(1 if wrong or (arguments.check and drifts) else 0)


def placed_units(names, jobs):
    """{unit: (logic cells, MHz)} of those that find room."""
    if not place.is_there():
        print("nextpnr-ice40 is not installed: no unit is placed", file=sys.stderr)
        return {}
    units = [unit for unit in names if unit in place.Placeable]
    with ThreadPoolExecutor(jobs) as pool:
        placed = dict(zip(units, pool.map(place.place, units)))
    for unit, (cells, frequency) in placed.items():
        print(unit, place.Chip, cells, frequency, flush=True)
    return placed


def measured(names, before, cache, placed, arguments):
    """The units' costs, and the cache's sizes into `cache`. The page gets each as it comes: yosys
    works for long."""
    costs = {}
    kept = {unit: figures for unit, figures in before.items() if unit in units()}

    def take(unit, figures):
        costs[unit] = figures
        if not arguments.check:
            Page.write_text(page({**kept, **costs}, cache, placed))

    with ThreadPoolExecutor(arguments.jobs) as pool:
        sizes = {pool.submit(cost, "texel_cache", {"SetBits": bits}): bits
                 for bits in CacheSetBits if "texel_cache" in names}
        todo = {**sizes,
                **{pool.submit(cost, unit): unit for unit in names if unit not in Composed}}
        for done in as_completed(todo):
            if done in sizes:
                cache[sizes[done]] = done.result()[3]
            else:
                take(todo[done], done.result())
    for unit in Composed:
        if unit in names:
            take(unit, cost(unit, known={**kept, **costs}))
    return costs


if __name__ == "__main__":
    main()
