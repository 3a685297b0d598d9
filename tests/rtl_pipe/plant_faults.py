#!/usr/bin/env python3
"""plant_faults.py BUILD [--jobs N] [--protocol] [--keep] [--places]: faults planted in the fragment
pipe's own glue, which its test has to see.

All are built into one Verilated pipe, beside a copy of the test program of the build tree BUILD; each
is run by its number. The protocol checker is bound to every channel, and flops wake up with random
numbers. A test that fails, an assertion, a crash or a hang kills one; survivors are listed, exit
status 1. Number 0 is the pipe as it is, and has to pass. --protocol: that alone, and how fast it
is with the assertions; --keep: what was built before is run again; --places: only whether each
fault has its one place in the RTL.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

Root = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(Root / "tests/rtl"))
from mutants import Chosen  # noqa: E402
from verilated_tree import build_tree  # noqa: E402

Work = Root / "out" / "pipe_mutants"
Rtl = Root / "rtl"
Seconds = 150  # of the processor that a mutant may take, whatever else it has to do

# Kind, file, expression, what stands in its place. The expression stands once in the file.
Mutants = [
    ("dropped valid", "raster_front", "covered_valid && side_ready", "covered_valid && side_ready && covered.x[3:1] != 3'd5"),
    ("dropped valid", "target_stages", "in_valid_i && lives", "in_valid_i && lives && in_data_i.x[4:1] != 4'd7"),
    ("dropped valid", "target_write", "waits && waiting_stores", "waits && waiting_stores && store_o[3:0] != 4'd5"),
    ("dropped valid", "texture_unit", "request_valid && level_ready", "request_valid && level_ready && request.live != 4'd6"),
    ("lost quad", "target_write", "out_ready_i && register_ready", "register_ready"),
    ("doubled", "target_write", "in_valid_i && register_ready", "in_valid_i"),
    ("stale state", "draw_registers", "write_i && tag_i", "write_i && tag_i && state_i.sampled_units == 8'd0"),
    ("stale state", "target_read", "free.tag ? format_1_i : format_0_i", "format_0_i"),
    ("stale state", "target_read", "free.tag ? place_1_i : place_0_i", "free.tag ? place_0_i : place_1_i"),
    ("stale state", "attribute_pass", "quad.tag ? carried_1_i : carried_0_i", "carried_1_i"),
    ("stale state", "divisor_pass", "quad.tag ? carried_1_i : carried_0_i", "carried_0_i"),
    ("stale state", "environment_loop", "entering.tag ? combiners_1_i : combiners_0_i", "combiners_0_i"),
    ("stale state", "sample_collect", "(quad.tag ? sampled_units_1_i : sampled_units_0_i) != 8'd0", "sampled_units_1_i != 8'd0"),
    ("stale state", "attribute_pass", "has_w_q && !is_last", "has_w_q"),
    ("stale state", "texel_supply", "!invalidate_i", "1'b1"),
    ("tag mismatch", "texture_banks", "named_q[0] && name_0_q == name", "named_q[0] && name_0_q[2:0] == name[2:0]"),
    ("tag mismatch", "texture_banks", "(victim ? count_1_q : count_0_q) == '0", "1'b1"),
    ("tag mismatch", "draw_tracker", "count_0_q == '0 && !(walking_i && !tag_i)", "1'b1"),
    ("tag mismatch", "draw_tracker", "count_1_q == '0 && !(walking_i && tag_i)", "!(walking_i && tag_i)"),
    ("tag mismatch", "draw_tracker", "!waits_i[0]", "1'b1"),
    ("tag mismatch", "texel_fetch", "in_data_i.header", "{~in_data_i.header.tag, in_data_i.header[0 +: $bits(in_data_i.header) - 1]}"),
    ("hazard", "quad_interlock", "meets == '0", "1'b1"),
    ("hazard", "quad_interlock", "used_q[i]", "used_q[i] && i != 3"),
    ("hazard", "target_write", "waits && (store_ready_i || !waiting_stores)", "waits"),
    ("slots", "record_store", "!is_walked", "1'b1"),
    ("slots", "record_store", "counts_q[CountWidth*oldest +: CountWidth] == '0", "1'b1"),
    ("slots", "raster_front", "!sequence_ready || !tile_ready || covered_valid", "!sequence_ready"),
    ("order", "divisor_pass", "started_q <= !is_last", "started_q <= 1'b0"),
    ("order", "attribute_pass", "!takes_q || divisor_valid_i", "1'b1"),
    ("order", "sample_collect", "(quad.live & above) == 4'd0", "1'b1"),
    ("order", "sample_collect", "sample_i.place[5]", "1'b1"),
    ("order", "texel_supply", "note_valid && !note.is_border && out_ready_i", "note_valid && out_ready_i"),
    ("order", "texel_gather", "texel_q == filter_i.last_texel", "texel_q >= 3'd3 || texel_q == filter_i.last_texel"),
    ("order", "environment_loop", "left_q & (left_q - 8'd1)", "8'd0"),
    ("order", "tile_sequence", "last_column ? row_q + 8'd1 : row_q", "row_q + 8'd1"),
    ("bytes", "target_write", "upper_enables << upper_byte", "upper_enables << lower_byte[0]"),
    ("bytes", "target_write", "8'({in_data_i.enables[13:12], in_data_i.enables[9:8]})", "8'h0f"),
    ("bytes", "target_place", "surface_i.stride * {19'd0, y_i}", "surface_i.stride * {19'd0, y_i[12:5], 5'd0}"),
    ("bytes", "texel_supply", "data.block >> {note.offset, 3'd0}", "data.block >> {note.offset[2:0], 3'd0}"),
    ("not held", "pipeline_register", "in_ready_o && in_valid_i", "in_valid_i"),
    ("not held", "fifo", "read_q != {~write_q[IndexWidth], write_q[IndexWidth-1:0]}", "1'b1"),
    ("doubled", "fifo", "read_q != write_q", "read_q != write_q || Depth == 4"),
    ("doubled", "target_read", "!reads || words_valid", "1'b1"),
    ("order", "texel_cache", "!head_missed || come_q[head_fill]", "1'b1"),
    ("order", "texel_cache", "come_q[head_fill] <= 1'b0", "come_q[head_fill] <= 1'b1"),
    ("slots", "texel_cache", "first_fill_q != {~next_fill_q[FillBits], next_fill_q[FillBits-1:0]}", "1'b1"),
    ("order", "texel_fetch", "texel_q == last_texel", "texel_q == last_texel || texel_q == 3'd2"),
    ("stale state", "texel_fetch", "is_last ? 3'd0 : texel_q + 3'd1", "texel_q + 3'd1"),
    ("hazard", "quad_interlock", "!used_q[last_q]", "1'b1"),
    ("hazard", "quad_interlock", "first_q + 1'b1", "first_q"),
    ("slots", "record_store", "{fill, plane_i.attribute}", "{fill ^ 2'd1, plane_i.attribute}"),
    ("slots", "record_store", "counts_d[CountWidth*done_slot_i +: CountWidth] - 8'd1", "counts_d[CountWidth*done_slot_i +: CountWidth]"),
    ("slots", "raster_front", "{slot_q, covered}", "{2'd0, covered}"),
    ("stale state", "texture_banks", "named_q     <= 2'b00", "named_q     <= 2'b01"),
    ("bytes", "texel_fetch", "{3'd0, x[13:3]}", "{3'd0, x[12:2]}"),
    ("tag mismatch", "texture_banks", "in_data_i.live[lane] && enters", "enters"),
    ("tag mismatch", "target_stages", "tested_valid && !tested_lives", "1'b0"),
    ("order", "quad_collect", "(value_valid_i && is_last)", "value_valid_i"),
    ("bytes", "raster_front", "{2'd0, covered.y} - shading.y_reference", "{2'd0, covered.y} - shading.x_reference"),
    ("stale state", "environment_loop", "shaded_q.quad.color <= in_data_i.primary", "shaded_q.quad.color <= {32'd0, in_data_i.secondary}"),
    ("not reset", "texel_gather", "texel_q <= 3'd0", "texel_q <= texel_q"),
    ("not reset", "environment_loop", "inside_q   <= 1'b0", "inside_q <= inside_q"),
    ("bytes", "sample_collect", "sample_i.color", "sample_i.color ^ {31'd0, at == 5'd6}"),
    ("bytes", "target_place", "{upper[2:1], 1'b0}", "{lower[2:1], 1'b0}"),
    ("stale state", "target_read", "ffgpu_pipe_pkg::pixel_bytes_log2(waiting_format)", "ffgpu_pipe_pkg::pixel_bytes_log2(format)"),
    ("stale state", "texture_banks", "sampled_i && sampled_bank_i", "sampled_i && last_bank_q"),
    ("hazard", "quad_interlock", "used_q[last_q] <= 1'b1", "used_q[last_q] <= !release_i"),
    ("tag mismatch", "draw_tracker", "Width'(bits[1]) + Width'(bits[2])", "Width'(bits[1] | bits[2])"),
    ("tag mismatch", "target_stages", "depth_waits | color_waits", "color_waits"),
    ("clamp", "attribute_pass", "quotient_scale < LeastScale", "1'b0"),
    ("clamp", "attribute_pass", "quotient_scale > LargestScale", "1'b0"),
    ("stale state", "record_store", "plane_i.attribute[1:0] == 2'd3", "plane_i.attribute[1:0] == 2'd3 && plane_i.attribute[5:4] == 2'd1"),
    ("order", "sample_collect", "4'b1110 << at[1:0]", "4'b1110 << {1'b0, at[0]}"),
    ("order", "quad_collect", "{attribute[5], attribute[3:2]}", "{1'b0, attribute[3:2]}"),
    ("stale state", "attribute_pass", "takes_q ? divisor_i : over_q_q", "divisor_i"),
    ("order", "texel_cache", "head_valid && head_ready && head_missed", "head_valid && is_there && head_missed"),
    ("hazard", "quad_interlock", "used_q[first_q] <= 1'b0", "used_q[first_q] <= used_q[first_q] && enters"),
    ("tag mismatch", "cache_tags", "tags[TagWidth*way +: TagWidth] == tag", "tags[TagWidth*way + 3 +: TagWidth - 3] == tag[TagWidth-1:3]"),
    ("too slow", "cache_ages", "ages_i[WayBits*way +: WayBits] < age", "ages_i[WayBits*way +: WayBits] > age"),
    ("doubled", "fragment_pipe", "record_valid_i && record_ready_o", "record_valid_i"),
    ("slots", "interpolator", "quad_valid && quad_ready", "quad_valid"),
    ("order", "lowest_attribute", "attributes_i & (attributes_i - 48'd1)", "attributes_i & (attributes_i - 48'd1) & 48'hffff_ffff_ff0f"),
    ("order", "lowest_attribute", "lowest & 48'hff00_ff00_ff00", "lowest & 48'h0000_ff00_ff00"),
    ("stale state", "shading_stages", "state_0_i.sampled_units", "state_1_i.sampled_units"),
    ("too slow", "texel_fetch", "!header.linear", "1'b0"),
    ("too slow", "texture_banks", "last_bank_q <= bank", "last_bank_q <= last_bank_q"),
    ("too slow", "tile_sequence", "record_q.box_x1 - 14'd1", "record_q.box_x1"),
    ("tag mismatch", "texture_banks", "(victim ? count_1_q : count_0_q) == '0", "(victim ? count_1_q[4:0] : count_0_q[4:0]) == '0"),
    ("lost sample", "sample_collect", "(!is_last || out_ready_i)", "(!is_last || out_ready_i || sample_i.place[4:2] == 3'd7)"),
    ("lost texel", "texel_gather", "filter_valid_i && (!is_last || out_ready_i)", "filter_valid_i && (!is_last || out_ready_i || texel_q == 3'd7)"),
    ("doubled", "texel_fetch", "in_valid_i && (!is_last || filter_ready_i)", "in_valid_i"),
    ("clamp", "attribute_pass", "ffgpu_pkg::PerspectiveFog", "3'd0"),
    ("clamp", "raster_front", "record.depth_min", "24'd0"),
    ("rounding", "raster_front", "record.depth_origin", "{record.depth_origin[63:1], 1'b0}"),
    ("bytes", "texel_fetch", "row_stride * {18'd0, row}", "(row_stride * {18'd0, row}) & 32'h00ff_ffff"),
    ("bytes", "texel_fetch", "layer_stride * {18'd0, z}", "(layer_stride * {18'd0, z}) & 32'h0fff_ffff"),
    ("bytes", "target_place", "lower + surface_i.stride", "lower + {16'd0, surface_i.stride[15:0]}"),
    ("too slow", "fifo", "read_q != {~write_q[IndexWidth], write_q[IndexWidth-1:0]}", "out_valid_o == 1'b0 || read_q[IndexWidth-1:0] != write_q[IndexWidth-1:0] + 1'b1"),
]


def planted(expression, mutant, number):
    """The expression, with its mutant where that number is chosen. Statements keep their left side."""
    if "<=" in expression:
        left, right = expression.split(" <= ")
        return f"{left} <= ({Chosen} == {number} ? ({mutant.split(' <= ')[1]}) : ({right}))"
    return f"({Chosen} == {number} ? ({mutant}) : ({expression}))"


# Units whose channels are checked beside registers and queues: those with an output for each input,
# those with another number of them.
OneToOne = ["alpha_test", "apply_coverage", "attribute_plane", "blend", "color_sum", "depth_plane",
            "environment_loop", "fog", "interpolator", "level_of_detail", "perspective",
            "quad_interlock", "reciprocal", "shading_stages", "stencil_depth", "target_read",
            "texel_cache", "texel_decode", "texel_supply", "texture_environment"]
OneToMany = ["filter_tree", "raster_front", "texel_address", "texel_fetch", "texel_sequence",
             "texture_unit", "tile_sequence", "tile_walker"]
UnitCheck = """bind {unit} unit_checker #(
  .InWidth($bits(in_data_i)), .OutWidth($bits(out_data_o)), .OneToOne(1'b{one}),
  .MostInside(256), .MostIdle(16384)
) u_checker (
  .clk_i, .rst_ni, .in_valid_i, .in_ready_i(in_ready_o), .in_data_i,
  .out_valid_i(out_valid_o), .out_ready_i, .out_data_i(out_data_o)
);
"""


def checks():
    units = [UnitCheck.format(unit=u, one=int(u in OneToOne)) for u in OneToOne + OneToMany]
    text = (Root / "tests/rtl_pipe/pipe_checks.sv.in").read_text()
    return text.replace("@units@", "\n".join(units))


def check_places():
    """Each fault has its one place in the RTL as it is."""
    wrong = []
    for _, name, expression, _ in Mutants:
        places = (Rtl / f"{name}.sv").read_text().count(expression)
        if places != 1:
            wrong.append(f"{name}: '{expression}' stands {places} times")
    if wrong:
        sys.exit("\n".join(wrong))


def write_sources():
    check_places()
    shutil.rmtree(Work, ignore_errors=True)
    (Work / "rtl").mkdir(parents=True)
    for file in Rtl.glob("*.sv"):
        text = file.read_text()
        for number, (_, name, expression, mutant) in enumerate(Mutants, 1):
            if name != file.stem:
                continue
            begin = text.index(expression)
            text = text[:begin] + planted(expression, mutant, number) + text[begin + len(expression):]
        (Work / "rtl" / file.name).write_text(text)
    (Work / "rtl" / "pipe_checks.sv").write_text(checks())


def build(tree):
    """The library and the test, in a tree like the build's."""
    build_tree(Work, tree, Work / "rtl",
               ["--assert", "--x-assign", "unique", "--x-initial", "unique"],
               [Root / "tests/rtl/unit_checker.sv", Work / "rtl/pipe_checks.sv"],
               [Root / "tests/rtl/mutant.cpp"], "-O1")


def run(number, test="rtl_pipe_test"):
    """Whether the test passes with the mutant."""
    environment = {**os.environ, "FFGPU_RTL_MUTANT": str(number)}
    return subprocess.run(["prlimit", f"--cpu={Seconds}", Work / "tests" / test, "--abort", "~replay*"],
                          env=environment, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode == 0


def speed(ffgpu):
    """Million cycles a second of the host's processor, as ffgpu tells for a frame of a trace."""
    told = subprocess.run([ffgpu, "replay", Root / "traces/corridor.trace", "--rtl", "fragment_pipe",
                           "--frames", "0-0", "--no-images"], check=True, capture_output=True,
                          text=True).stderr
    return float(re.search(r"([\d.]+) million cycles a second", told)[1])


def protocol(tree):
    """The pipe as it is under the checker at every channel: its test, and what the checker costs."""
    if not run(0):
        sys.exit("the test fails with the protocol checker at every channel")
    print("the protocol holds at every channel of the pipe")
    print(f"{speed(tree / 'tools/ffgpu'):.3f} million cycles a second, "
          f"{speed(Work / 'tools/ffgpu'):.3f} with the assertions")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--protocol", action="store_true")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--places", action="store_true", help="only that each fault has one")
    arguments = parser.parse_args()
    if arguments.places:
        return check_places()
    if not arguments.keep:
        write_sources()
        build(arguments.build)
    if arguments.protocol:
        return protocol(arguments.build)
    if not run(0):
        sys.exit("the test fails without a mutant")
    with ThreadPoolExecutor(arguments.jobs) as pool:
        survives = list(pool.map(tell, range(1, len(Mutants) + 1)))
    print(f"{len(Mutants) - sum(survives)} of {len(Mutants)} killed")
    sys.exit(1 if any(survives) else 0)


def tell(number):
    survived, mutant = run(number), Mutants[number - 1]
    print(f"{'SURVIVED' if survived else 'killed  '} {number:2} {mutant[0]:13} {mutant[1]}: "
          f"{mutant[2]} -> {mutant[3]}", flush=True)
    return survived


if __name__ == "__main__":
    main()
