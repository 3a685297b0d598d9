"""A unit placed and routed on an iCE40 by yosys' synth_ice40 and nextpnr-ice40: its logic cells, and
the frequency that it achieves.

A unit has more ports than a package has pins: it stands between two shift registers, one that feeds
its inputs and one that takes its outputs, so that every path lies between flops.
"""
import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from ports import Packages, Rtl, ports

Chip = "hx8k"  # the largest iCE40
Package = "ct256"
Room = 7680  # logic cells, of a LUT of four inputs and a flop
Seed = 1
# Those that are placed on it within minutes, beside their shift registers.
Placeable = ("alpha_test", "apply_coverage", "color_sum", "draw_tracker", "fifo",
             "quad_interlock", "reciprocal", "skid_buffer", "target_write", "texel_gather",
             "tile_sequence")


def is_there():
    return shutil.which("nextpnr-ice40") is not None


def between_shift_registers(unit):
    """SystemVerilog of a design of four pins with the unit in it."""
    beside = [p for p in ports(unit) if p[2] not in ("clk_i", "rst_ni")]
    nets = "\n".join(f"  {kind} {name};" for _, kind, name in beside)
    inputs = [name for way, _, name in beside if way == "input"]
    outputs = [name for way, _, name in beside if way == "output"]
    bits = {side: " + ".join(f"$bits({name})" for name in names)
            for side, names in (("in", inputs), ("out", outputs))}
    return f"""
module placed (input logic clk_i, input logic rst_ni, input logic bit_i, output logic bit_o);
{nets}
  logic loads;
  logic [{bits["in"]}:0] in_q;
  logic [{bits["out"]}-1:0] out_q;

  assign {{loads, {", ".join(inputs)}}} = in_q;
  {unit} u_unit (.clk_i, {".rst_ni, " if has_reset(unit) else ""}{", ".join(f".{n}" for n in inputs + outputs)});
  always_ff @(posedge clk_i) begin
    in_q  <= {{in_q, bit_i}};
    out_q <= loads ? {{{", ".join(outputs)}}} : out_q >> 1;
  end
  assign bit_o = out_q[0];
endmodule
"""


def has_reset(unit):
    return any(name == "rst_ni" for _, _, name in ports(unit))


def place(unit):
    """(logic cells, MHz), the shift registers' cells left out."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / "placed.sv").write_text(between_shift_registers(unit))
        files = " ".join(str(Rtl / f"{name}.sv") for name in [*Packages, unit])
        script = (f"read_verilog -sv {files} {folder}/placed.sv; "
                  f"hierarchy -check -libdir {Rtl} -top placed; "
                  f"proc; write_json {folder}/nets.json; "
                  f"synth_ice40 -top placed -json {folder}/placed.json")
        subprocess.run(["yosys", "-q", "-p", script], check=True, stdout=subprocess.DEVNULL)
        nets = json.loads((folder / "nets.json").read_text())["modules"]["placed"]["netnames"]
        shifted = sum(len(nets[name]["bits"]) for name in ("in_q", "out_q"))
        subprocess.run(["nextpnr-ice40", "--quiet", f"--{Chip}", "--package", Package,
                        "--seed", str(Seed), "--pcf-allow-unconstrained",
                        "--json", folder / "placed.json", "--report", folder / "report"],
                       check=True, stderr=subprocess.DEVNULL)
        report = json.loads((folder / "report").read_text())
    cells = report["utilization"]["ICESTORM_LC"]["used"] - shifted
    return cells, round(min(clock["achieved"] for clock in report["fmax"].values()), 1)
