#!/usr/bin/env python3
"""prove.py [PROOF ...]: claims about the RTL that yosys proves for all inputs.

Those of tests/rtl/proofs, a module each, its claims as assertions: of gates by SAT, of flops by
induction over the clock, or from a reset on "For N cycles". Each has lines "Refused with: MODULE:
EXPRESSION -> ANOTHER", faults with which it must not be proved. Exit status 1 where a claim does
not hold, or a fault is not refused; 77 without yosys.
"""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from mutate import Rtl, inside
from ports import Packages

Proofs = Path(__file__).resolve().parent / "proofs"
Claims = "channel_claims"
Seconds = 300  # that yosys may take for one
Cycles = re.compile(r"^// For (\d+) cycles", re.M)
Fault = re.compile(r"^// Refused with: (\w+): (.+?) -> (.+)$", re.M)


def modules(text):
    """Those of rtl/ that a proof is about."""
    named = re.findall(r"^  (\w+)(?: #\($| u_\w+ \($)", text, re.M)
    return list(dict.fromkeys(m for name in named for m in inside(name)))


def proves(file, rtl):
    """Whether yosys proves the claims, of RTL that stands in a folder."""
    text = file.read_text()
    sources = [rtl / f"{name}.sv" for name in [*Packages, "ffgpu_pipe_pkg", *modules(text)]]
    sources += [Proofs / f"{Claims}.sv"] if Claims + " #(" in text else []
    cycles = Cycles.search(text)
    time = f"-seq {cycles[1]}" if cycles else \
        "-tempinduct -seq 1 -maxsteps 12" if "clk_i" in text else ""
    script = (f"read_verilog -sv -formal {' '.join(map(str, [*sources, file]))}; "
              f"hierarchy -check -top {file.stem}_proof; proc; flatten; opt; memory_map; async2sync; "
              "opt; "
              f"sat -verify -prove-asserts -set-assumes {time}")
    run = subprocess.run(["yosys", "-q", "-p", script], capture_output=True, text=True,
                         timeout=Seconds)
    if run.returncode != 0 and "proof did fail" not in run.stderr:
        sys.exit(f"{file.stem}:\n{run.stderr}")
    return run.returncode == 0


def refuses(file, fault):
    module, before, after = fault
    with tempfile.TemporaryDirectory() as folder:
        for source in Rtl.glob("*.sv"):
            shutil.copy(source, folder)
        faulty = Path(folder) / f"{module}.sv"
        text = faulty.read_text()
        if text.count(before) == 0:
            sys.exit(f"{file.stem}: '{before}' stands nowhere in {module}")
        faulty.write_text(text.replace(before, after, 1))
        return not proves(file, Path(folder))


def holds(file):
    proved = proves(file, Rtl)
    text = file.read_text()
    cycles, faults = Cycles.search(text), Fault.findall(text)
    print(f"{'proved' if proved else 'DOES NOT HOLD'}: {file.stem}" +
          (f", for {cycles[1]} cycles" if cycles else ""), flush=True)
    kept = [fault for fault in faults if not refuses(file, fault)]
    for module, before, after in kept:
        print(f"  NOT REFUSED: {module}: {before} -> {after}", flush=True)
    return proved and faults and not kept


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("proofs", nargs="*")
    names = parser.parse_args().proofs
    if not shutil.which("yosys"):
        print("yosys is not installed: no proofs")
        sys.exit(77)
    files = [f for f in sorted(Proofs.glob("*.sv")) if f.stem != Claims]
    results = [holds(f) for f in files if not names or f.stem in names]
    print(f"{sum(map(bool, results))} of {len(results)} proofs hold")
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
