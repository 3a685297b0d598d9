// One channel blended: both products exactly, sum or difference, one clamp, one rounding. Equations
// beyond the list add.
//
// Combinational. Equals blend_channel() in model/fragment/blend.cpp.

module blend_channel (
  input  ffgpu_registers_pkg::blend_equation_e equation_i,
  input  ffgpu_pkg::channel_t                  source_i,
  input  ffgpu_pkg::channel_t                  source_factor_i,
  input  ffgpu_pkg::channel_t                  destination_i,
  input  ffgpu_pkg::channel_t                  destination_factor_i,
  output ffgpu_pkg::channel_t                  result_o
);

  localparam logic [16:0] OneSquared = 17'd65025;

  logic [15:0] source_product, destination_product, clamped;
  logic [16:0] s, d, sum;

  assign source_product      = {8'd0, source_i} * {8'd0, source_factor_i};
  assign destination_product = {8'd0, destination_i} * {8'd0, destination_factor_i};
  assign s = {1'b0, source_product};
  assign d = {1'b0, destination_product};

  always_comb begin
    unique case (equation_i)
      ffgpu_registers_pkg::BlendEquationSubtract:        sum = s > d ? s - d : 17'd0;
      ffgpu_registers_pkg::BlendEquationReverseSubtract: sum = d > s ? d - s : 17'd0;
      default:                                           sum = s + d;
    endcase
  end

  assign clamped = sum > OneSquared ? OneSquared[15:0] : sum[15:0];

  always_comb begin
    unique case (equation_i)
      ffgpu_registers_pkg::BlendEquationMin:
        result_o = source_i < destination_i ? source_i : destination_i;
      ffgpu_registers_pkg::BlendEquationMax:
        result_o = source_i > destination_i ? source_i : destination_i;
      default: result_o = ffgpu_pkg::divide_255(clamped);
    endcase
  end

endmodule
