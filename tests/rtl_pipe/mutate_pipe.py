#!/usr/bin/env python3
"""mutate_pipe.py BUILD [--seed N] [--mutants N] [--jobs N] [--keep]: how many planted faults in the
fragment pipe's own files its test sees.

Mutants of the files that no unit's test is of, drawn by the seed and spread over kinds, are built into
one Verilated pipe with the protocol checker at every channel, and run one after the other by their
numbers (plant_faults.py, whose list is written by hand). Survivors are given to yosys, which may prove
that their module computes the same; the others are listed, exit status 1.
"""
import argparse
import os
import random
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import plant_faults
from plant_faults import Root, Rtl
from verilated_tree import build_tree

sys.path.insert(0, str(Root / "tests/rtl"))
import mutants  # noqa: E402
import mutate  # noqa: E402
from equivalence import Mutant, proves  # noqa: E402

Work = Root / "out" / "pipe_random_mutants"


def glue():
    """Modules of the pipe that stand in no unit with a test of its own."""
    tested = {name for unit in mutate.units() for name in mutate.inside(unit)}
    return [name for name in mutate.inside("fragment_pipe") if name not in tested]


def draw(count, seed):
    """(module, line, kind, from, to), the kinds in turn."""
    by_kind = {}
    for module in glue():
        _, made = mutants.schemata((Rtl / f"{module}.sv").read_text(), 0, lambda *_: True)
        for mutant in made:
            by_kind.setdefault(mutant[2], []).append((module, *mutant[1:]))
    rng = random.Random(f"{seed} pipe")
    for choices in by_kind.values():
        rng.shuffle(choices)
    chosen = []
    while len(chosen) < count and any(by_kind.values()):
        for kind in sorted(by_kind):
            if by_kind[kind] and len(chosen) < count:
                chosen.append(by_kind[kind].pop())
    return chosen


def write_sources(chosen):
    """The RTL with the mutants in it; [(number, module, line, kind, from, to)]."""
    shutil.rmtree(Work / "rtl", ignore_errors=True)
    (Work / "rtl").mkdir(parents=True)
    for file in Rtl.glob("*.sv"):
        shutil.copy(file, Work / "rtl")
    numbered = []
    for module in dict.fromkeys(m[0] for m in chosen):
        picks = {m[1:] for m in chosen if m[0] == module}
        text, made = mutate.pick((Rtl / f"{module}.sv").read_text(), len(numbered) + 1, picks)
        (Work / "rtl" / f"{module}.sv").write_text(text)
        numbered += [(number, module, *rest) for number, *rest in made]
    (Work / "rtl/pipe_checks.sv").write_text(plant_faults.checks())
    return numbered


def is_equivalent(mutant, seconds):
    """Whether yosys proves that the mutant's module and the original compute the same."""
    number, module = mutant[:2]
    pair = Mutant("fragment_pipe", number, module, (Work / "rtl" / f"{module}.sv").read_text(),
                  Work / "proof" / str(number), mutate.inside)
    return proves(pair.induction(module, ""), seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--mutants", type=int, default=60)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--proof-seconds", type=int, default=600, help="that yosys may take for one")
    parser.add_argument("--keep", action="store_true", help="run what was built before, by the same seed")
    arguments = parser.parse_args()
    if not arguments.keep:
        shutil.rmtree(Work, ignore_errors=True)
    numbered = write_sources(draw(arguments.mutants, arguments.seed))
    if not arguments.keep:
        build_tree(Work, arguments.build, Work / "rtl",
                   ["--assert", "--x-assign", "unique", "--x-initial", "unique"],
                   [Root / "tests/rtl/unit_checker.sv", Work / "rtl/pipe_checks.sv"],
                   [Root / "tests/rtl/mutant.cpp"], "-O1")
    plant_faults.Work = Work
    if not plant_faults.run(0):
        sys.exit("the test fails without a mutant")
    if plant_faults.run(0, "rtl_pipe_blind_test"):
        sys.exit("the test passes with the comparison off")

    def tell(mutant):
        lives = plant_faults.run(mutant[0])
        proved = lives and is_equivalent(mutant, arguments.proof_seconds)
        number, module, line, kind, before, after = mutant
        word = "the same" if proved else "SURVIVES" if lives else "killed"
        print(f"{word:8} {number:2} {kind:13} {module}.sv:{line}: {before}  ->  {after}", flush=True)
        return word

    with ThreadPoolExecutor(arguments.jobs) as pool:
        words = list(pool.map(tell, numbered))
    print(f"{len(words)} mutants, {words.count('killed')} killed, {words.count('the same')} proved to "
          f"be the same, {words.count('SURVIVES')} survive")
    sys.exit(1 if "SURVIVES" in words else 0)


if __name__ == "__main__":
    main()
