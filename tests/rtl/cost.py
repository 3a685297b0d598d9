#!/usr/bin/env python3
"""cost.py [--check] [UNIT...]: what each RTL unit costs on an ECP5, by yosys, into docs/rtl_cost.md.

--check: compares with the page, and fails where a figure is more than 3 % off.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

Root = Path(__file__).resolve().parents[2]
Rtl = Root / "rtl"
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
    packages = ["ffgpu_registers_pkg.sv", "ffgpu_pkg.sv", "ffgpu_texture_pkg.sv",
                "ffgpu_pipe_pkg.sv"]
    files = " ".join(str(Rtl / f) for f in packages + [f"{unit}.sv"])
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


def page(costs, cache):
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
{cache_table(cache)}"""


def read_page():
    """The figures of each unit on the page, and the cache's memory bits by the bits of its sets."""
    text = Page.read_text() if Page.exists() else ""
    rows = re.findall(r"^\| ([a-z]\w+) \| ([\d |]+) \|$", text, re.M)
    sizes = re.findall(r"^\| (\d+) \| \d+ \| \d+ \| (\d+) \|$", text, re.M)
    return ({unit: tuple(int(f) for f in figures.split(" | ")) for unit, figures in rows},
            {int(sets).bit_length() - 1: int(memory) for sets, memory in sizes})


def drifts_of(names, before, costs):
    drifts = [f"{unit}: {column} was {old}, is {new}"
              for unit in names
              for column, old, new in zip(Columns, before.get(unit, ()), costs[unit])
              if abs(new - old) > Tolerance * old]
    drifts += [f"{unit}: not on the page" for unit in names if unit not in before]
    return drifts + [f"{unit}: on the page, not in rtl/" for unit in before if unit not in units()]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("units", nargs="*")
    arguments = parser.parse_args()
    names = arguments.units or units()
    before, cache = read_page()
    costs = measured(names, before, cache, arguments)
    wrong = [f"texel_cache of {1 << bits} sets: {memory} memory bits, not {cache_memory(bits)}"
             for bits, memory in cache.items() if memory != cache_memory(bits)]
    drifts = drifts_of(names, before, costs) + wrong
    print(*(drifts if arguments.check else wrong), sep="\n")
    sys.exit(1 if wrong or (arguments.check and drifts) else 0)


def measured(names, before, cache, arguments):
    """The units' costs, and the cache's sizes into `cache`. The page gets each as it comes: yosys
    works for long."""
    costs = {}
    kept = {unit: figures for unit, figures in before.items() if unit in units()}

    def take(unit, figures):
        costs[unit] = figures
        if not arguments.check:
            Page.write_text(page({**kept, **costs}, cache))

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
