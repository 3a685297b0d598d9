// A texel_axis and a mutated one compute the same, but for what the first clamp leaves beyond the
// image, which does not matter within these bounds: tests/rtl/proofs/texel_margin.sv. What is
// mirrored lies in two images, since it is twice a fraction; twice -0 is -2^-126 here.

module both (
  input ffgpu_texture_pkg::texel_operands_t operands_i
);

  localparam int unsigned Stages = 7;
  localparam int unsigned Clamp = 3;
  localparam int unsigned Mirror = 4;
  localparam ffgpu_pkg::float_t MinusOne = 32'hbf80_0000;
  localparam ffgpu_pkg::float_t MinusFour = 32'hc080_0000;
  localparam ffgpu_pkg::float_t Two = 32'h4000_0000;
  localparam ffgpu_pkg::float_t Four = 32'h4080_0000;
  localparam ffgpu_pkg::float_t TwiceMinusZero = 32'h8080_0000;

  logic [32*Stages-1:0] gold_values, gold_others, gate_values, gate_others;
  ffgpu_pkg::float_t    gold, gate, rectangle_least, rectangle_most, least, most;
  logic                 is_clamped, is_possible;

  for (genvar stage = 0; stage < Stages; stage++) begin : g_stage
    texel_axis #(
      .Stage(stage)
    ) u_gold (
      .enable_i  (1'b1),
      .operands_i,
      .value_o   (gold_values[32*stage +: 32]),
      .other_o   (gold_others[32*stage +: 32])
    );
    mutated #(
      .Stage(stage)
    ) u_gate (
      .enable_i  (1'b1),
      .operands_i,
      .value_o   (gate_values[32*stage +: 32]),
      .other_o   (gate_others[32*stage +: 32])
    );
    if (stage != Clamp) begin : g_equal
      always_comb begin
        assert (gold_values[32*stage +: 32] == gate_values[32*stage +: 32] ||
                (stage == Mirror && !is_possible));
      end
    end
  end

  float_from_signed u_least (
    .enable_i (1'b1),
    .integer_i({19'd0, operands_i.rule.size} + 32'd1),
    .value_o  (rectangle_least)
  );
  float_from_signed u_most (
    .enable_i (1'b1),
    .integer_i({19'd0, operands_i.rule.size} + 32'd4),
    .value_o  (rectangle_most)
  );

  assign is_possible = operands_i.rule.fold != ffgpu_texture_pkg::FoldMirror ||
    operands_i.walk.values[31:0] <= Two || operands_i.walk.values[31:0] == TwiceMinusZero;

  assign gold       = gold_values[32*Clamp +: 32];
  assign gate       = gate_values[32*Clamp +: 32];
  assign least      = operands_i.rule.is_rectangle ? rectangle_least : Two;
  assign most       = operands_i.rule.is_rectangle ? rectangle_most : Four;
  assign is_clamped = operands_i.rule.fold == ffgpu_texture_pkg::FoldClamp ||
    operands_i.rule.fold == ffgpu_texture_pkg::FoldMirrorClamp;

  always_comb begin
    assert (gold_others == gate_others);
    assert (gold == gate || (is_clamped && gold >= least && gold <= most &&
                             gate >= least && gate <= most) ||
            (is_clamped && gold >= MinusOne && gold <= MinusFour &&
             gate >= MinusOne && gate <= MinusFour));
  end

endmodule
