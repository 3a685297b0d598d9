// One channel blended: both products exactly, sum or difference, one clamp, one rounding. Equations
// beyond the list add.
//
// Combinational. Equals blend_channel() in model/fragment/blend.cpp.

module blend_channel (
  input  logic                                 enable_i,  // low: nobody looks at the result
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
  logic [7:0]  rounded;

  always_comb begin
    source_product      = 16'd0;
    destination_product = 16'd0;
    clamped             = 16'd0;
    s                   = 17'd0;
    d                   = 17'd0;
    sum                 = 17'd0;
    if (enable_i) begin
      source_product      = {8'd0, source_i} * {8'd0, source_factor_i};
      destination_product = {8'd0, destination_i} * {8'd0, destination_factor_i};
      s                   = {1'b0, source_product};
      d                   = {1'b0, destination_product};
      unique case (equation_i)
        ffgpu_registers_pkg::BlendEquationSubtract:        sum = s > d ? s - d : 17'd0;
        ffgpu_registers_pkg::BlendEquationReverseSubtract: sum = d > s ? d - s : 17'd0;
        default:                                           sum = s + d;
      endcase
      clamped = sum > OneSquared ? OneSquared[15:0] : sum[15:0];
    end
    rounded = ffgpu_pkg::divide_255(clamped);
    unique case (equation_i)
      ffgpu_registers_pkg::BlendEquationMin:
        result_o = source_i < destination_i ? source_i : destination_i;
      ffgpu_registers_pkg::BlendEquationMax:
        result_o = source_i > destination_i ? source_i : destination_i;
      default: result_o = rounded;
    endcase
  end

endmodule
