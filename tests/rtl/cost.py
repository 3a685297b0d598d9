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
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

Root = Path(__file__).resolve().parents[2]
Rtl = Root / "rtl"
Page = Root / "docs" / "rtl_cost.md"
Tolerance = 0.03
Columns = ("LUT", "flip-flops", "DSP", "memory bits", "longest path")


def units():
    tests = (Root / "tests/rtl").glob("*_test.cpp")
    names = (p.name[: -len("_test.cpp")] for p in tests)
    return sorted(n for n in names if (Rtl / f"{n}.sv").exists())


def cost(unit):
    """The five figures of a unit: of a design flattened and mapped, before placement."""
    packages = ["ffgpu_registers_pkg.sv", "ffgpu_pkg.sv", "ffgpu_texture_pkg.sv",
                "ffgpu_pipe_pkg.sv"]
    modules = [p.name for p in sorted(Rtl.glob("*.sv")) if not p.name.endswith("_pkg.sv")]
    files = " ".join(str(Rtl / f) for f in packages + modules)
    with tempfile.TemporaryDirectory() as scratch:
        script = (f"read_verilog -sv {files}; synth_ecp5 -top {unit}; "
                  f"tee -q -o {scratch}/stat.json stat -json; delete t:TRELLIS_FF t:DP16KD; tee -q -o {scratch}/path ltp")
        subprocess.run(["yosys", "-q", "-p", script], check=True, stdout=subprocess.DEVNULL)
        design = json.loads(Path(scratch, "stat.json").read_text())["design"]
        path = Path(scratch, "path").read_text()
    cells = design["num_cells_by_type"]
    # A carry cell holds two LUTs, a cell of distributed memory 64 bits, a block 18432.
    luts = cells.get("LUT4", 0) + 2 * cells.get("CCU2C", 0)
    memory = (design["num_memory_bits"] + 64 * cells.get("TRELLIS_DPR16X4", 0) +
              18432 * cells.get("DP16KD", 0))
    longest = int(re.search(r"length=(\d+)", path)[1])
    return (luts, cells.get("TRELLIS_FF", 0), cells.get("MULT18X18D", 0), memory, longest)


def page(costs):
    version = subprocess.run(["yosys", "-V"], capture_output=True, text=True).stdout.split()[1]
    rows = "".join(f"| {unit} | " + " | ".join(str(f) for f in figures) + " |\n"
                   for unit, figures in sorted(costs.items()))
    return f"""# What the RTL costs

By `./dev rtl-cost`: each unit alone, with yosys {version} (`synth_ecp5`), flattened and mapped, before placement. A carry cell counts as two LUTs. The longest path is the number of
cells on it between flops, not a time: a carry chain of 24 bits is 12 cells and fast.

| unit | {" | ".join(Columns)} |
|---|{"---|" * len(Columns)}
{rows}
Quads carry their key (96 bits) and, up to fog, eight units' samples (1024 bits) through every stage: that is most of the flip-flops of the environments. Data that a build never
looks at goes away with the ports that end it.
"""


def read_page():
    rows = re.findall(r"^\| (\w+) \| ([\d |]+) \|$", Page.read_text(), re.M) if Page.exists() else []
    return {unit: tuple(int(f) for f in figures.split(" | ")) for unit, figures in rows}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("units", nargs="*")
    arguments = parser.parse_args()
    names = arguments.units or units()
    before = read_page()
    with ThreadPoolExecutor(arguments.jobs) as pool:
        costs = dict(zip(names, pool.map(cost, names)))
    drifts = [f"{unit}: {column} was {old}, is {new}"
              for unit in names for column, old, new in zip(Columns, before.get(unit, ()), costs[unit])
              if abs(new - old) > Tolerance * old]
    drifts += [f"{unit}: not on the page" for unit in names if unit not in before]
    for unit in names:
        print(unit, *costs[unit])
    if arguments.check:
        print(*drifts, sep="\n")
        sys.exit(1 if drifts else 0)
    Page.write_text(page({**before, **costs}))


if __name__ == "__main__":
    main()
