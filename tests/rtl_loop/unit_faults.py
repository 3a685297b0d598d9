"""Faults in each unit of the fragment pipe that stands in a stage of the model, and where `ffgpu diff`
has to name them: (file, expression, what stands in its place, draw, stage, lane, field).

The draws are those of scene/one_quad_draws.cpp, whose quad is told by the draw's number; the one that
a fault shows in first follows from the fault alone. A draw's registers stand in bank 0 where its
number, from 0 on, is even.
"""

BankZero, BankOne = "state_0_i", "state_1_i"
Chosen = "quad.tag ? state_1_i : state_0_i"


def covered(file, expression, mutant, lane=0):
    return (file, expression, mutant, "plain", "coverage", lane, "covered")


def depth(file, expression, mutant, draw="depth", lane=0):
    return (file, expression, mutant, draw, "depth", lane, "depth")


def primary(file, expression, mutant, lane=0):
    return (file, expression, mutant, "plain", "colors", lane, "primary")


def w(file, expression, mutant, lane=0):
    return (file, expression, mutant, "perspective", "perspective", lane, "w")


def sample(file, expression, mutant, draw="nearest", lane=0):
    return (file, expression, mutant, draw, "texture 0", lane, "sample")


def environment(file, expression, mutant, draw="nearest", lane=0):
    return (file, expression, mutant, draw, "environment 0", lane, "color")


def added(file, expression, mutant, draw="color sum", lane=0):
    return (file, expression, mutant, draw, "color_sum", lane, "color")


def fog(file, expression, mutant, draw, lane=0):
    return (file, expression, mutant, draw, "fog", lane, "color")


def stored(file, expression, mutant, draw, lane=0):
    return (file, expression, mutant, draw, "color_write 0", lane, "stored")


# What a factor is, and the draw that has it as the source's; the destination's is 1 in all.
FactorValues = [
    (0, "8'd255"), (2, "source_i[At +: 8]"), (3, "~source_i[At +: 8]"),
    (4, "destination_i[At +: 8]"), (5, "~destination_i[At +: 8]"), (6, "source_alpha"),
    (7, "~source_alpha"), (8, "destination_alpha"), (9, "~destination_alpha"),
    (10, "state_i.constant[At +: 8]"), (11, "~state_i.constant[At +: 8]"),
    (12, "state_i.constant[31:24]"), (13, "~state_i.constant[31:24]"),
    (14, "channel == 3 ? 8'd255 : saturated")]

Faults = [
    # Coverage, depth, attributes.
    covered("tile_walker", "inside_edges & inside_box", "inside_edges & inside_box & 4'b1011", 2),
    covered("tile_edge", "!value[Width-1]", "!value[Width-1] && lane != 1", 1),
    covered("pipeline_register", "data_q <= in_data_i", "data_q <= in_data_i ^ 1"),
    depth("depth_plane", "corner_q.corner + quad.dx + quad.dy", "corner_q.corner + quad.dy", lane=3),
    depth("depth_plane_lane", "sum_i + Half", "sum_i + Half + 64'd16777216"),
    depth("depth_plane_lane", "depth_o = depth_max_i", "depth_o = depth_min_i", "above"),
    depth("depth_plane_lane", "rounded[63]", "1'b0", "below"),
    primary("attribute_plane", "base + up[Width-1:ffgpu_pkg::GuardBits]", "base", 2),
    primary("perspective", "last.values", "last.values ^ 128'd2"),
    primary("perspective_stage", "left.values = values",
            "left.values = values ^ {62'd0, 2'd3, 64'd0}", 2),
    primary("perspective_lane", "{24'd0, color}", "{24'd0, color ^ {7'd0, Lane == 3}}", 3),
    primary("float_from_signed", "8'd158", "8'd159"),
    primary("float_multiply", "8'd127", "8'd126"),
    primary("float_clamp", "value_i[30:0] < Most[30:0]", "value_i[30:0] > Most[30:0]"),
    primary("float_add", "greater[30:23] + 8'd1 - {3'd0, leading}",
            "greater[30:23] + 8'd2 - {3'd0, leading}"),
    primary("float_to_unsigned", "mantissa >> shift[4:0]",
            "(mantissa >> shift[4:0]) ^ Width'(1)"),
    w("reciprocal", "(is_power ? 8'd254 : 8'd253)", "8'd254"),
    w("reciprocal_stage", "in_data_i.quotient[Width-1-QuotientBits:0]",
      "in_data_i.quotient[Width-1-QuotientBits:0] ^ 20'd1"),

    # Texture units.
    sample("level_of_detail", "x_square >= y_square", "x_square < y_square", "anisotropic"),
    sample("level_of_detail", "last.tag ? state_1_i : state_0_i", BankZero, "nearest"),
    sample("level_of_detail", "last.tag ? state_1_i : state_0_i", BankOne, "nearest, other bank"),
    sample("level_stage", "left.values = values",
           "left.values = values ^ (Stage == 4 ? (192'd1 << 24) ^ (192'd1 << 120) : 0)", "mipmaps"),
    sample("level_stage", "in_data_i.tag ? state_1_i : state_0_i", BankOne, "mipmaps"),
    sample("level_step", "texels[30:0] < LeastStep[30:0]", "texels[30:0] > LeastStep[30:0]",
           "mipmaps"),
    sample("level_logarithm", "{exponent, fraction}", "{exponent, fraction ^ 8'h40}", "mipmaps"),
    sample("log2_table", "(index_i)", "index_i ^ 8'h40", "mipmaps"),
    sample("level_probes", "longer - {6'd0, taken}", "longer - {6'd0, taken} + 18'd90", "mipmaps"),
    sample("level_choice", "last > down ? lambda_i[7:0] : 8'd0",
           "last > down ? lambda_i[7:0] ^ 8'd64 : 8'd0", "mipmaps"),
    sample("texel_address", "weights[7:0]",
           "weights[7:0] ^ {header.lane == 2'd2, 7'd0}", lane=2),
    sample("texel_address", "header.tag ? state_1_i : state_0_i", BankZero),
    sample("texel_sequence", "quad_q.coordinates[96*lane +: 96]",
           "quad_q.coordinates[96*(lane == 2'd3 ? 2'd2 : lane) +: 96]", lane=3),
    sample("texel_stage", "{header, values, others}",
           "{header, values ^ {87'd0, header.lane == 2'd1, 8'd0}, others}", lane=1),
    sample("texel_stage", "header.tag ? state_1_i : state_0_i", BankZero),
    sample("texel_pair", "from_centre[7:0]", "from_centre[7:0] ^ 8'h80", "linear"),
    sample("axis_rule", "(wrap)", "(wrap == ffgpu_registers_pkg::WrapMirroredRepeat ? "
           "ffgpu_registers_pkg::WrapRepeat : wrap)", "mirrored"),
    sample("texel_axis", "back[30:0] < value[30:0]", "1'b0", "mirrored"),
    sample("probe_position", "{probes_i, probe_i}", "{probes_i, 5'd1}", "anisotropic"),
    sample("float_to_signed", "value_i[31] ? -magnitude : magnitude", "magnitude + 24'd512"),
    sample("texel_decode", "decoded_q.srgb && !decoded_q.is_border ? linear : color",
           "~color"),
    sample("s3tc_color", "block_i[{1'b1, texel_i, 1'b0} +: 2]",
           "block_i[{1'b1, texel_i, 1'b0} +: 2] ^ 2'd1", "dxt1"),
    sample("s3tc_alpha", "block_i[code_at +: 3]", "block_i[code_at +: 3] ^ 3'd1", "dxt5"),
    sample("fxt1_texel", "!is_clear", "is_clear", "fxt1"),
    sample("srgb_table", "Table[{code_i, 3'd0} +: 8]", "~Table[{code_i, 3'd0} +: 8]", "srgb"),
    sample("filter_tree", "has_fine_q ? fine_q : level.texels[31:0]", "level.texels[31:0]",
           "mipmaps"),
    sample("filter_axis", "in_data_i.weight_x", "in_data_i.weight_x ^ 8'h80"),
    sample("texture_lerp", "ffgpu_pkg::lerp8w(a_i[8*channel +: 8], b_i[8*channel +: 8], weight_i)",
           "ffgpu_pkg::lerp8w(a_i[8*channel +: 8], b_i[8*channel +: 8], weight_i ^ 8'h80)"),
    sample("filter_mean", "biased * {13'd0, inverse}", "biased * {13'd0, inverse} + 30'd65536"),
    sample("filter_mean", "17'd16384", "17'd8192", "anisotropic"),

    # Environments, colour sum, fog, coverage, alpha test.
    environment("texture_environment", "colored_3.color = color",
                "colored_3.color = color ^ (128'd1 << 64)", lane=2),
    environment("texture_environment", "quad_1.tag ? state_1_i : state_0_i", BankZero),
    environment("texture_environment", "quad_2.tag ? state_1_i : state_0_i", BankOne, "modulate"),
    environment("texture_environment", "quad_3.tag ? state_1_i : state_0_i", BankZero),
    environment("combine_argument", "color = constant_i", "color = ~constant_i", "modulate"),
    environment("combine_operation", "CombineOpModulate: first_factor = a1",
                "CombineOpModulate: first_factor = a0", "modulate"),
    environment("combine_operation", "One - a2", "a2", "interpolate"),
    environment("combine_dot", "{sum[18:0], 1'b0}", "~{sum[18:0], 1'b0}", "dot product"),
    environment("combine_finish", "{1'b0, doubled_i, 1'b0}", "{2'b0, doubled_i}", "scaled"),
    environment("combine_finish", "clamped + 22'd255", "clamped + 22'd765"),
    added("color_sum", "sum[8] ? 8'd255 : sum[7:0]", "sum[8] || lane == 3 ? 8'd255 : sum[7:0]",
          lane=3),
    added("color_sum", Chosen, BankZero),
    added("color_sum", Chosen, BankOne, "color sum, other bank"),
    fog("fog", Chosen, BankZero, "fog linear"),
    fog("fog", Chosen, BankOne, "fog exponential"),
    fog("fog", "~last.values[32*lane +: 8]", "~last.values[32*lane +: 8] ^ {lane == 2, 7'd0}",
        "fog linear", 2),
    fog("fog_stage", Chosen, BankZero, "fog linear"),
    fog("fog_stage", Chosen, BankOne, "fog exponential"),
    fog("fog_lane", "is_linear ? difference : product", "product", "fog linear"),
    fog("fog_lane", "is_linear ? value_i : fixed", "value_i", "fog exponential"),
    fog("fog_lane", "curve_i.mode != ffgpu_registers_pkg::FogModeExp2", "1'b1", "fog squared"),
    fog("exp2_negative", "base - {6'd0, drop}", "18'd66000",
        "fog exponential"),
    fog("exp2_table", "(chord_i)", "chord_i ^ 6'h20", "fog exponential"),
    ("apply_coverage", "ffgpu_pkg::divide_255(alpha * coverage)",
     "ffgpu_pkg::divide_255(alpha * coverage) ^ {7'd0, lane == 1}", "below", "antialias", 1, "color"),
    ("alpha_test", "in_data_i.live & passes", "in_data_i.live & passes & 4'b1011", "plain",
     "alpha_test", 2, "passed"),
    ("alpha_test", "in_data_i.tag ? state_1_i : state_0_i", BankZero, "plain, other bank",
     "alpha_test", 0, "passed"),
    ("alpha_test", "in_data_i.tag ? state_1_i : state_0_i", BankOne, "plain", "alpha_test", 0,
     "passed"),

    # Targets.
    ("stencil_depth", "quad.live & passes", "quad.live & passes & 4'b1101", "plain",
     "stencil_depth", 1, "passed_depth"),
    ("stencil_depth", Chosen, BankZero, "depth", "stencil_depth", 0, "new_depth"),
    ("stencil_depth", Chosen, BankOne, "stencil", "stencil_depth", 0, "new_stencil"),
    ("stencil_depth_core", "stored_stencil == 8'd255 ? 8'd255 : stored_stencil + 8'd1",
     "stored_stencil + 8'd2", "stencil", "stencil_depth", 0, "new_stencil"),
    stored("blend", "quad_1.tag ? state_1_i : state_0_i", BankZero, "factor 0"),
    stored("blend", "quad_2.tag ? state_1_i : state_0_i", BankOne, "factor 1"),
    stored("blend", "quad_3.tag ? state_1_i : state_0_i", BankZero, "plain, other bank"),
    stored("blend", "quad_3.live[lane] ? lane_enables : 4'd0",
           "quad_3.live[lane] && lane != 3 ? lane_enables : 4'd0", "plain", 3),
    *[stored("blend_factors", f"value = {value}", "value = 8'd3", f"factor {factor}")
      for factor, value in FactorValues],
    stored("blend_channel", "s > d ? s - d : 17'd0", "d > s ? d - s : 17'd0", "equation 1"),
    stored("blend_channel", "source_i < destination_i", "source_i > destination_i", "equation 3"),
    stored("color_write", "LogicOpXor:          combined = source ^ stored_i",
           "LogicOpXor:          combined = source | stored_i", "logic 6"),
    stored("color_write", "~(source & stored_i)", "~(source | stored_i)", "logic 14"),
    stored("pixel_pack", "{16'd0, five[14:10], six, five[4:0]}",
           "{16'd0, five[4:0], six, five[14:10]}", "narrow"),
    stored("pixel_level", "{8'd0, value_i} * Maximum", "{8'd0, ~value_i} * Maximum", "narrow"),
    stored("pixel_level", "value_i - (value_i >> Width)", "8'd0", "dithered"),
    stored("pixel_unpack", "{Opaque, pixel_i[4:0], pixel_i[4:2], pixel_i[10:5], pixel_i[10:9],\n"
           "                   pixel_i[15:11], pixel_i[15:13]}", "{Opaque, 24'h808080}",
           "narrow, blended"),
]
