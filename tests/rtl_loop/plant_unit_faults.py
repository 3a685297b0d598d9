#!/usr/bin/env python3
"""plant_unit_faults.py BUILD [--keep] [--places]: whether `ffgpu diff` names faults of the RTL units.

At least one is planted in each module of the units that carry out a stage of the model, both banks of
their registers included (unit_faults.py). All are built into one library of Verilated units, in the
build tree BUILD/unit_faults; each is run by its number, over draws of one quad each. Stage, quad, lane,
field and the unit have to be those that stand with the fault; number 0 is the units as they are, and
nothing differs. --keep: what was built before is run again; --places: only whether each fault has its
one place in the RTL, and each module one fault.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from unit_faults import Faults

Root = Path(__file__).resolve().parents[2]
Rtl = Root / "rtl"
sys.path.insert(0, str(Root / "tests/rtl"))
import mutate  # noqa: E402
from mutants import Chosen  # noqa: E402

# Those of rtl/loop, in the order of the pipe.
Units = ["tile_walker", "depth_plane", "attribute_plane", "reciprocal", "perspective",
         "level_of_detail", "texel_address", "texel_decode", "filter_tree", "texture_environment",
         "color_sum", "fog", "apply_coverage", "alpha_test", "stencil_depth", "blend"]


def check_places():
    """Each fault has one place in the RTL as it is, and each module a fault."""
    places = [(file, expression, len(re.findall(whole(expression),
                                                (Rtl / f"{file}.sv").read_text())))
              for file, expression, *_ in Faults]
    wrong = [f"{file}: '{expression}' stands {count} times"
             for file, expression, count in places if count != 1]
    modules = {module for unit in Units for module in mutate.inside(unit)}
    wrong += [f"{module}: has no fault" for module in sorted(modules - {f[0] for f in Faults})]
    if wrong:
        sys.exit("\n".join(wrong))


def whole(expression):
    """Its pattern, where no name or selection goes on."""
    return r"(?<!\w)" * expression[0].isalnum() + re.escape(expression) + r"(?![\w\[])"


def planted(expression, mutant, number):
    """Of an expression; of an assignment its right side."""
    for sign in (" <= ", " = "):
        if sign in expression and re.match(r"[\w:. ]+$", expression.split(sign)[0]):
            left, right = expression.split(sign, 1)
            return f"{left}{sign}{planted(right, mutant.split(sign, 1)[1], number)}"
    return f"({Chosen} == {number} ? ({mutant}) : ({expression}))"


def write_sources(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for file in Rtl.glob("*.sv"):
        text = file.read_text()
        by_place = {}  # several faults of one expression stand inside each other
        for number, (name, expression, mutant, *_) in enumerate(Faults, 1):
            if name == file.stem:
                by_place.setdefault(expression, []).append((number, mutant))
        for expression, faults in by_place.items():
            result = expression
            for number, mutant in faults:
                result = planted(expression, mutant, number) if result == expression else \
                    f"({Chosen} == {number} ? ({mutant}) : {result})"
            text = text.replace(expression, result)
        written = folder / file.name
        if not written.exists() or written.read_text() != text:
            written.write_text(text)


def build(tree, place):
    """The units with faults, beside the programs of the tree and a capture."""
    write_sources(place / "rtl")
    subprocess.run(["cmake", "-S", Root, "-B", place / "build", "-G", "Ninja",
                    "-DCMAKE_CXX_COMPILER_LAUNCHER=" + (shutil.which("ccache") or ""),
                    f"-DFFGPU_RTL_UNITS={place / 'rtl'}"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", place / "build", "-j", str(os.cpu_count()), "--target",
                    "ffgpu_rtl"], check=True, stdout=subprocess.DEVNULL)
    (place / "build/tools").mkdir(exist_ok=True)
    shutil.copy(tree / "tools/ffgpu", place / "build/tools/ffgpu")


def diff(place, number):
    """(exit status, what diff prints) with a fault."""
    environment = {**os.environ, "FFGPU_RTL_MUTANT": str(number)}
    run = subprocess.run([place / "build/tools/ffgpu", "diff", place / "draws.ffc", "--backend-b",
                          "rtl"], env=environment, capture_output=True, text=True, timeout=60)
    return run.returncode, run.stdout


def named(text):
    """What diff names: (stage, place, field), and the unit."""
    found = re.search(r"stage +(.+)\n +place +.*quad (\d+),(\d+) lane (\d).*\n +field +(\w+)", text)
    unit = re.search(r"First of B's units to part from the model: (\w+)", text)
    return found and (found[1], int(found[2]), int(found[3]), int(found[4]), found[5]), \
        unit and unit[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--places", action="store_true")
    arguments = parser.parse_args()
    check_places()
    if arguments.places:
        return
    place = arguments.build.resolve() / "unit_faults"
    if not arguments.keep:
        build(arguments.build, place)
    draws = subprocess.run([arguments.build / "tests/one_quad_draws", place / "draws.ffc"],
                           check=True, capture_output=True, text=True).stdout.splitlines()
    if diff(place, 0)[0] != 0:
        sys.exit("the units differ from the model without a fault")
    wrong = 0
    for number, (file, _, mutant, draw, stage, lane, field) in enumerate(Faults, 1):
        due = (stage, 2 * draws.index(draw), 0, lane, field)
        got, unit = named(diff(place, number)[1])
        is_right = got == due and unit and file in mutate.inside(unit)
        wrong += not is_right
        print(f"{'right' if is_right else 'WRONG'} {number:3} {file}: {mutant}: {draw}: {stage}, quad "
              f"{due[1]},{due[2]}, lane {lane}, {field}, unit {unit}" +
              ("" if is_right else f"; named {got}"), flush=True)
    print(f"{len(Faults) - wrong} of {len(Faults)} named right, in {len({f[0] for f in Faults})} modules")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
