// One step of one axis from a coordinate to a texel coordinate of a level: to the probe, folded by
// the wrap mode, in texels with 8 fraction bits.
//
// Combinational; Stage says which step it is. Equals move_to_probe() in
// model/texture/coordinates.h, and fold_coordinate() and texel_coordinate() in wrap.h.

module texel_axis #(
  parameter int unsigned Stage = 0,
  parameter int unsigned Axis = 0
) (
  input  logic                               enable_i,  // low: nobody looks at the values
  input  ffgpu_texture_pkg::texel_operands_t operands_i,
  output logic [31:0]                        value_o,
  output logic [31:0]                        other_o
);

  localparam logic [31:0] One = 32'h3f80_0000;
  localparam logic [31:0] Two = 32'h4000_0000;

  ffgpu_texture_pkg::texel_walk_t walk;
  logic [31:0]                    value;

  assign walk  = operands_i.walk;
  assign value = walk.values[32*Axis +: 32];

  if (Stage == 0) begin : g_step
    ffgpu_pkg::float_t position;

    probe_position u_position (
      .probes_i  (walk.header.probes),
      .probe_i   (walk.header.probe),
      .position_o(position)
    );
    float_multiply u_step (
      .enable_i,
      .a_i      (walk.others[32*Axis +: 32]),
      .b_i      (position),
      .product_o(other_o)
    );
    assign value_o = value;
  end else if (Stage == 1) begin : g_probe
    ffgpu_pkg::float_t at;

    // A single probe stands at the coordinate: its step was 0 times.
    float_add u_move (
      .enable_i,
      .a_i  (value),
      .b_i  (walk.others[32*Axis +: 32]),
      .sum_o(at)
    );
    // A mirrored one repeats after two images.
    always_comb begin
      value_o = at;
      if (operands_i.rule.fold == ffgpu_texture_pkg::FoldMirror) begin
        value_o = {at[31], at[30:23] - {7'd0, |at[30:23]}, at[22:0]};
      end
      if (operands_i.rule.fold == ffgpu_texture_pkg::FoldMirrorClamp) begin
        value_o = {1'b0, at[30:0]};
      end
    end
    assign other_o = '0;
  end else if (Stage == 2) begin : g_floor
    logic [23:0]       below;  // the mantissa's fraction bits
    ffgpu_pkg::float_t whole, floor_value;

    // Below 1 in magnitude there is no whole; from 2^23 on no fraction.
    assign below = value[30:23] >= 8'd150 ? 24'd0 : 24'h7f_ffff >> (value[30:23] - 8'd127);
    assign whole = value[30:23] < 8'd127 ? 32'd0 : value & ~{8'd0, below};
    float_add u_floor (
      .enable_i,
      .a_i  (whole),
      .b_i  (32'hbf80_0000),
      .sum_o(floor_value)
    );
    // What is subtracted: the next whole number below.
    assign other_o = value[31] && whole[30:0] != value[30:0] ? floor_value : whole;
    assign value_o = value;
  end else if (Stage == 3) begin : g_fraction
    ffgpu_pkg::float_t other, fraction, clamped, most;

    assign other = walk.others[32*Axis +: 32];

    float_add u_fraction (
      .enable_i,
      .a_i  (value),
      .b_i  ({~other[31], other[30:0]}),
      .sum_o(fraction)
    );
    float_from_signed u_most (
      .enable_i,
      .integer_i(operands_i.rule.is_rectangle ? {19'd0, operands_i.rule.size} + 32'd1 : 32'd2),
      .value_o  (most)
    );
    // Of positive numbers the bits compare as integers.
    always_comb begin
      clamped = value;
      if (value[31] && value[30:0] > One[30:0]) begin
        clamped = {1'b1, One[30:0]};
      end
      if (!value[31] && value[30:0] > most[30:0]) begin
        clamped = most;
      end
    end
    // Twice 0 becomes 2^-126, which is 0 in texels.
    always_comb begin
      value_o = clamped;
      if (operands_i.rule.fold == ffgpu_texture_pkg::FoldRepeat) begin
        value_o = fraction;
      end
      if (operands_i.rule.fold == ffgpu_texture_pkg::FoldMirror) begin
        value_o = {fraction[31], fraction[30:23] + 8'd1, fraction[22:0]};
      end
    end
    assign other_o = '0;
  end else if (Stage == 4) begin : g_mirror
    ffgpu_pkg::float_t back;

    float_add u_back (
      .enable_i,
      .a_i  (Two),
      .b_i  ({~value[31], value[30:0]}),
      .sum_o(back)
    );
    assign value_o = operands_i.rule.fold == ffgpu_texture_pkg::FoldMirror && back[30:0] < value[30:0] ? back : value;
    assign other_o = '0;
  end else if (Stage == 5) begin : g_scale
    ffgpu_pkg::float_t scale;

    float_from_signed u_scale (
      .enable_i,
      .integer_i(operands_i.rule.is_rectangle ? 32'd256 : {11'd0, operands_i.rule.level_size, 8'd0}),
      .value_o  (scale)
    );
    float_multiply u_texels (
      .enable_i,
      .a_i      (value),
      .b_i      (scale),
      .product_o(value_o)
    );
    assign other_o = '0;
  end else begin : g_clamp
    logic [23:0] low, raw, high, at_least, clamped;

    assign low = operands_i.rule.low;
    float_to_signed u_raw (
      .value_i  (value),
      .integer_o(raw)
    );
    always_comb begin
      high     = 24'd0;
      at_least = 24'd0;
      clamped  = 24'd0;
      if (enable_i) begin
        high     = {3'd0, operands_i.rule.level_size, 8'd0} + operands_i.rule.above;
        at_least = {~raw[23], raw[22:0]} < {~low[23], low[22:0]} ? low : raw;
        clamped  = {~at_least[23], at_least[22:0]} > {~high[23], high[22:0]} ? high : at_least;
      end
    end
    assign value_o  = {8'd0, clamped};
    assign other_o  = {30'd0, operands_i.rule.wraps, operands_i.rule.border};
  end

endmodule
