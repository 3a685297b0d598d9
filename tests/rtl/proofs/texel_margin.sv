// What a coordinate beyond the image is clamped to before it is scaled does not matter, from two
// images to four, or of a rectangle from a texel beyond to four, and below from -1 to -4: in texels
// it comes out at the last clamp's bound.
// Refused with: texel_axis: > {~high[23], high[22:0]} ? high -> > {~high[23], high[22:0]} ? low
// Refused with: texel_axis: < {~low[23], low[22:0]} ? low -> < {~low[23], low[22:0]} ? raw
// Refused with: float_to_signed: shift > 8'd25 -> shift > 8'd9

module texel_margin_proof (
  input ffgpu_pkg::float_t value_i,
  input logic [12:0]       size_i,
  input logic              is_rectangle_i,
  input logic [1:0]        low_i,
  input logic [1:0]        above_i
);

  localparam ffgpu_pkg::float_t MinusOne = 32'hbf80_0000;
  localparam ffgpu_pkg::float_t MinusFour = 32'hc080_0000;
  localparam ffgpu_pkg::float_t Two = 32'h4000_0000;
  localparam ffgpu_pkg::float_t Four = 32'h4080_0000;

  // Half a texel inside, at the edge, half a texel outside.
  function automatic logic [23:0] bound(
    input logic [1:0] which
  );
    bound = which == 2'd0 ? 24'd0 : which == 2'd1 ? 24'd128 : -24'd128;
  endfunction

  ffgpu_texture_pkg::axis_rule_t      rule;
  ffgpu_texture_pkg::texel_operands_t scaled, clamped;
  ffgpu_pkg::float_t                  texels, least, most;
  logic [31:0]                        result, no_other, modes;

  always_comb begin
    rule                       = '0;
    rule.is_rectangle          = is_rectangle_i;
    rule.size                  = size_i;
    rule.level_size            = size_i;
    rule.low                   = bound(low_i);
    rule.above                 = bound(above_i);
    scaled                     = '0;
    scaled.rule                = rule;
    scaled.walk.values[31:0]   = value_i;
    clamped                    = '0;
    clamped.rule               = rule;
    clamped.walk.values[31:0]  = texels;
  end

  texel_axis #(
    .Stage(5)
  ) u_scale (
    .enable_i  (1'b1),
    .operands_i(scaled),
    .value_o   (texels),
    .other_o   (no_other)
  );
  texel_axis #(
    .Stage(6)
  ) u_clamp (
    .enable_i  (1'b1),
    .operands_i(clamped),
    .value_o   (result),
    .other_o   (modes)
  );
  float_from_signed u_least (
    .enable_i (1'b1),
    .integer_i({19'd0, size_i} + 32'd1),
    .value_o  (least)
  );
  float_from_signed u_most (
    .enable_i (1'b1),
    .integer_i({19'd0, size_i} + 32'd4),
    .value_o  (most)
  );

  always_comb begin
    assume (size_i >= 13'd1 && size_i <= 13'd4096);
    if (value_i >= (is_rectangle_i ? least : Two) && value_i <= (is_rectangle_i ? most : Four)) begin
      assert (result[23:0] == {3'd0, size_i, 8'd0} + rule.above);
    end
    if (value_i >= MinusOne && value_i <= MinusFour) begin
      assert (result[23:0] == rule.low);
    end
  end

endmodule
