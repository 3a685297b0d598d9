#!/usr/bin/env python3
"""mutate.py [--seed N] [--units A,B] [--mutants N]: how many planted faults the RTL's tests see.

Mutants of each unit and of the modules inside it, drawn by the seed, are built into one program a
unit (mutants.py) and run one after the other: a test that fails, an assertion or a hang kills one.
Survivors meet the tests' long form, and are then given to yosys, which may prove that they compute the same; the others are listed, and
the exit status is 1. Also with the bench's comparison off: then each unit's tests have to fail.

ctest's short form is built beside the tests: --write puts the sources alone into --sources FOLDER, which
CMake has done, and --programs FOLDER runs what was made of them.
"""
import argparse
import os
import random
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import mutants
from equivalence import Mutant

Root = Path(__file__).resolve().parents[2]
Rtl = Root / "rtl"
Work = Root / "out" / "rtl_mutants"
Build = Root / "build-rtl-mutants"
Programs = Build / "tests/rtl"


Arithmetic = "float"  # The units of binary32 have one test, around which float_units.sv stands.

Exhausted = {"reciprocal", "exp2_table", "exp2_negative"}  # Of which tests try every input.


def units():
    """Names of the modules that have a test."""
    return sorted([Arithmetic] + [p.name[: -len("_test.cpp")]
                                  for p in (Root / "tests/rtl").glob("*_test.cpp")
                                  if (Rtl / (p.name[: -len("_test.cpp")] + ".sv")).exists()])


def inside(module):
    """The module and those that stand in it, itself first."""
    if module == Arithmetic:
        return arithmetic()
    found, todo = [], [module]
    while todo:
        name = todo.pop(0)
        if name in found or not (Rtl / f"{name}.sv").exists():
            continue
        found.append(name)
        text = (Rtl / f"{name}.sv").read_text()
        todo += re.findall(r"^\s+(\w+)(?: #\($|\s+u_\w+ \($)", text, re.M)
    return found


def arithmetic():
    text = (Root / "tests/rtl/float_units.sv").read_text()
    named = re.findall(r"^\s+(float_\w+)(?: #\($|\s+u_\w+ \($)", text, re.M)
    return list(dict.fromkeys(named))


def draw(unit, count, seed):
    """The mutants of a unit: {file: set of (kind, line, from, to)}, spread over the kinds."""
    rng = random.Random(f"{seed} {unit}")
    everything = []
    elsewhere = [] if unit == Arithmetic else arithmetic()
    for module in [m for m in inside(unit) if m not in elsewhere] + ["ffgpu_pkg"]:
        _, made = mutants.schemata((Rtl / f"{module}.sv").read_text(), 0, lambda *_: True)
        used = set(re.findall(r"ffgpu_pkg::(\w+)\(", "".join((Rtl / f"{m}.sv").read_text()
                                                           for m in inside(unit))))
        if module == "ffgpu_pkg":
            made = [m for m in made if function_at(m[1]) in used]
        everything += [(module, *m[1:]) for m in made]
    rng.shuffle(everything)
    by_kind = {}
    for mutant in everything:
        by_kind.setdefault(mutant[2], []).append(mutant)
    chosen = []
    while len(chosen) < count and any(by_kind.values()):
        for kind in sorted(by_kind):
            if by_kind[kind] and len(chosen) < count:
                chosen.append(by_kind[kind].pop())
    return chosen


def function_at(line):
    """The package's function that a line stands in."""
    before = (Rtl / "ffgpu_pkg.sv").read_text().splitlines()[:line]
    names = [m[1] for m in (re.match(r"\s*function automatic \w+ (\w+)\(", l) for l in before) if m]
    return names[-1] if names else ""


def write_sources(chosen):
    """One folder of RTL a unit with its mutants in it; returns {unit: [(number, file, ...)]}."""
    numbered = {}
    for unit, wanted in chosen.items():
        texts = {path.name: path.read_text() for path in Rtl.glob("*.sv")}
        number, numbered[unit] = 1, []
        for module in dict.fromkeys(m[0] for m in wanted):
            picks = {m[1:] for m in wanted if m[0] == module}
            texts[f"{module}.sv"], made = pick(texts[f"{module}.sv"], number, picks)
            numbered[unit] += [(n, module, *rest) for n, *rest in made]
            number += len(made)
        write_changed(Work / unit, texts)
    return numbered


def write_changed(folder, texts):
    """{name: text} into files; those that are as they were stay, and what was built of them."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        if not (folder / name).exists() or (folder / name).read_text() != text:
            (folder / name).write_text(text)


def pick(text, first, picks):
    """The schemata of the wanted mutants alone. Two passes: what there is, then what is kept."""
    _, everything = mutants.schemata(text, 0, lambda *_: True)
    wanted = [m[1:] in picks for m in everything]
    turn = iter(wanted)
    return mutants.schemata(text, first, lambda *_: next(turn))


def build(jobs):
    subprocess.run(["cmake", "-S", Root, "-B", Build, "-G", "Ninja", "-DFFGPU_RTL_MUTANTS=ON",
                    f"-DFFGPU_RTL_FOLDER={Work}", "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"],
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", Build, "-j", str(jobs), "--target", "rtl_mutants"],
                   check=True, stdout=subprocess.DEVNULL)


def passes(unit, **environment):
    """Whether a unit's tests pass: not if they fail, abort or hang."""
    program = Programs / f"rtl_{unit}_test"
    try:
        run = subprocess.run([program, "--abort"], env={**os.environ, **environment}, timeout=900,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return False
    return run.returncode == 0


def is_equivalent(unit, number, module):
    """Whether yosys proves that the mutant and the original compute the same."""
    mutated = (Work / unit / f"{module}.sv").read_text()
    return Mutant(unit, number, module, mutated, Work / "proof" / f"{unit}_{number}",
                  inside).is_equivalent()


def alive(pool, unit, numbered, **environment):
    """Those mutants that a unit's tests do not see."""
    passed = pool.map(lambda m: passes(unit, FFGPU_RTL_MUTANT=str(m[0]), **environment), numbered)
    return [m for m, lives in zip(numbered, list(passed)) if lives]


def main():
    global Work, Programs
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--units", default=",".join(units()))
    parser.add_argument("--mutants", type=int, default=24, help="of a unit")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--sources", type=Path, default=Work, help="where those with mutants stand")
    parser.add_argument("--write", action="store_true", help="the sources alone")
    parser.add_argument("--programs", type=Path, help="that were built of them")
    arguments = parser.parse_args()

    names, Work = arguments.units.split(","), arguments.sources
    for other in set(os.listdir(Work) if Work.exists() else []) - set(names):
        shutil.rmtree(Work / other)
    numbered = write_sources({unit: draw(unit, arguments.mutants, arguments.seed) for unit in names})
    if arguments.write:
        return
    if arguments.programs:
        Programs = arguments.programs
    else:
        build(arguments.jobs)
    sys.exit(0 if all([holds(unit, numbered[unit], arguments.jobs) for unit in names]) else 1)


def holds(unit, numbered, jobs):
    """Whether a unit's tests see all of its mutants that compute something else; tells of each."""
    if not passes(unit):
        sys.exit(f"{unit}: fails without a mutant")
    is_blind = passes(unit, FFGPU_RTL_BLIND="1")
    if is_blind:
        print(f"{unit}: passes with the comparison off")
    with ThreadPoolExecutor(jobs) as pool:
        survivors = alive(pool, unit, numbered)
        survivors = alive(pool, unit, survivors, FFGPU_RTL_LONG="1")
    proved = [m for m in survivors
              if not Exhausted.isdisjoint({unit, m[1]}) or is_equivalent(unit, m[0], m[1])]
    killed = len(numbered) - len(survivors)
    print(f"{unit}: {len(numbered)} mutants, {killed} killed, {len(proved)} proved to be "
          f"the same, {len(survivors) - len(proved)} survive", flush=True)
    for number, module, line, kind, before, after in survivors:
        word = "the same" if any(m[0] == number for m in proved) else "SURVIVES"
        print(f"  {word}: {module}.sv:{line} {kind}: {before}  ->  {after}", flush=True)
    return not is_blind and len(proved) == len(survivors)


if __name__ == "__main__":
    main()
