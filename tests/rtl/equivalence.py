"""Whether yosys proves that a mutant of the RTL computes the same as the original."""
import re
import subprocess
from pathlib import Path

import mutants
from ports import Packages, Rtl, ports

Tests = Path(__file__).resolve().parent

# What stands around modules that are mutated together and are no unit.
Around = {"float": "float_units"}
Everything = "1'b1"
# A part's value is taken where it is let to compute, and nowhere else: enable_checker.sv.
Enable = "enable_i"
Different = " && ".join(f"ages_i[{2 * i} +: 2] != ages_i[{2 * j} +: 2]"
                        for i in range(4) for j in range(i))
# What comes up at the inputs of combinational modules, where it is not everything. Of cache_ages it is
# what came out before, which the proof shows to be so.
Ranges = {"cache_ages": Different,
          "depth_plane_lane": "depth_min_i <= depth_max_i",
          "level_choice": "image_i.levels != 4'd0",
          "filter_mean": "count_i >= 5'd1 && count_i <= 5'd16 && {5'd0, sum_i} <= 17'd255 * count_i"}

# What has one name in both is compared: what is in between may differ where no flop takes it.
HideAllButRegisters = ("select -set kept t:$*dff* %co1 w:* %i i:* %u o:* %u; "
                       "select -set hidden w:* @kept %d; rename -hide @hidden; ")


class Mutant:
    """One mutant of a module, under the unit that it was drawn for, beside the original.

    `inside`: the files of a module and of those in it. `mutated`: the source with all mutants.
    """

    def __init__(self, unit, number, module, mutated, folder, inside):
        self.number, self.module = number, module
        self.unit = Around.get(unit, unit)
        self.inside = lambda name: [name, *inside(unit)] if name in Around.values() else inside(name)
        self.folder = Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.chosen = re.sub(re.escape(f"({mutants.Chosen} == ") + r"(\d+)\)",
                             lambda m: f"(1'b{int(int(m[1]) == number)})", mutated)
        (self.folder / f"{module}.sv").write_text(self.chosen)

    def is_equivalent(self):
        if self.module.endswith("_pkg"):
            return False
        if (Tests / "equal" / f"{self.module}.sv").exists() and self.is_equal_by_rule():
            return True
        if is_combinational(self.module):
            is_of_one_kind = self.module in Ranges or not has_parameters(self.module)
            if is_of_one_kind and self.is_equal_in_range():
                return True
            if any(map(self.is_equal_in, self.around())):
                return True
        if not has_parameters(self.module) and proves(self.induction(self.module, ""), 120):
            return True
        if is_combinational(self.unit):
            return False
        return (proves(self.induction(self.unit, ""), 120) or
                proves(self.induction(self.unit, HideAllButRegisters), 900))

    def read(self, top, place):
        files = " ".join(str(self.folder / f"{m}.sv" if place and m == self.module else source(m))
                         for m in self.inside(top))
        packages = " ".join(str(Rtl / f"{name}.sv") for name in Packages)
        return f"read_verilog -sv {packages} {files}; hierarchy -top {top}; "

    def induction(self, top, hidden):
        """Registers of one name in both are equal for all time."""
        def design(name, place):
            return (self.read(top, place) + "proc; flatten; opt; memory -nomap; opt; " + hidden +
                    f"rename -top {name}; design -stash {name}; ")
        return (design("gold", False) + design("gate", True) +
                "design -copy-from gold -as gold gold; design -copy-from gate -as gate gate; "
                "equiv_make gold gate equiv; hierarchy -top equiv; opt -full; equiv_struct; "
                "equiv_simple -undef; equiv_induct; equiv_status -assert")

    def is_equal_by_rule(self):
        """What tests/rtl/equal says of the module, and of the mutant as `mutated`, holds."""
        text = re.sub(rf"\bmodule {self.module}\b", "module mutated", self.chosen)
        (self.folder / "mutated.sv").write_text(text)
        return proves(f"read_verilog -sv -formal {self.originals()} {self.folder}/mutated.sv "
                      f"{Tests}/equal/{self.module}.sv; hierarchy -top both; "
                      "proc; flatten; opt -full; sat -verify -prove-asserts", 300)

    def originals(self):
        return " ".join(str(Rtl / f"{name}.sv") for name in Packages + self.inside(self.module))

    def is_equal_in_range(self):
        """The same by SAT, over the inputs that come up."""
        module = self.module
        inputs = [(kind, name) for way, kind, name in ports(module) if way == "input"]
        outputs = [(kind, name) for way, kind, name in ports(module) if way == "output"]
        nets = [f"{kind} {side}_{name};" for side in ("gold", "gate") for kind, name in outputs]
        cells = [f"{name} u_{side} ({', '.join(f'.{i}({driver(i)})' for _, i in inputs)}, "
                 f"{', '.join(f'.{o}({side}_{o})' for _, o in outputs)});"
                 for side, name in (("gold", module), ("gate", "mutated"))]
        equal = " && ".join(f"gold_{name} == gate_{name}" for _, name in outputs)
        if module == "cache_ages":
            equal += " && " + Different.replace("ages_i", "gold_ages_o")
        (self.folder / "both.sv").write_text(
            re.sub(rf"\bmodule {module}\b", "module mutated", self.chosen) +
            f"module both ({', '.join(f'input {kind} {name}' for kind, name in inputs)}); "
            f"{' '.join(nets)} {' '.join(cells)}\n"
            f"always_comb begin assume ({Ranges.get(module, Everything)}); assert ({equal}); "
            "end endmodule\n")
        return proves(f"read_verilog -sv -formal {self.originals()} {self.folder}/both.sv; "
                      "hierarchy -top both; proc; flatten; memory; opt; "
                      "sat -verify -prove-asserts -set-assumes", 300)

    def around(self):
        """The module and the combinational ones of the unit that it stands in, the least first."""
        return sorted((m for m in self.inside(self.unit) if m not in Around.values() and
                       is_combinational(m) and self.module in self.inside(m)),
                      key=lambda m: len(self.inside(m)))

    def is_equal_in(self, outer):
        """A module is the same by SAT, with each of the parameters that it has in the unit."""
        names = self.instances(outer)
        whole = "".join(self.read(self.unit, place) + f"design -stash all_{side}; "
                        for side, place in (("gold", False), ("gate", True)))
        return bool(names) and proves(whole + "".join(self.miter(name, has_enable(outer)) for name in names), 600)

    def instances(self, module):
        """Names that yosys gives a module with each of its parameters."""
        listed = output(self.read(self.unit, False) + "ls")
        return re.findall(rf"^ +(\$paramod\S*\\{module}(?:\\\S+)?|{module})$", listed, re.M)

    def miter(self, name, is_enabled):
        let = (f"delete -input w:{Enable}; connect -nounset -set {Enable} {Everything};"
               if is_enabled else "")

        def design(side):
            return (f"design -load all_{side}; hierarchy -top {name}; proc; flatten; {let} opt; "
                    f"rename {name} {side}; design -stash {side}; ")
        return (design("gold") + design("gate") + "design -reset; "
                "design -copy-from gold -as gold gold; design -copy-from gate -as gate gate; "
                "miter -equiv -flatten gold gate both; hierarchy -top both; opt -full; "
                "sat -verify -prove trigger 0; ")


def driver(port):
    return Everything if port == Enable else port


def has_enable(module):
    return any(name == Enable for _, _, name in ports(module))


def has_parameters(module):
    return "#(\n  parameter" in (Rtl / f"{module}.sv").read_text()


def is_combinational(module):
    return "clk_i" not in source(module).read_text()


def source(module):
    return (Tests if module in Around.values() else Rtl) / f"{module}.sv"


def proves(script, timeout):
    try:
        return subprocess.run(["yosys", "-q", "-p", script], timeout=timeout,
                              capture_output=True).returncode == 0
    except (subprocess.TimeoutExpired, FileNotFoundError):
        return False


def output(script):
    return subprocess.run(["yosys", "-p", script], capture_output=True, text=True).stdout
