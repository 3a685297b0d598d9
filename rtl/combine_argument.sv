// One argument of a combiner for one channel of a fragment. Sources beyond the list are zero.
//
// Combinational. Equals argument_value() in model/fragment/texture_environment.cpp.

module combine_argument #(
  parameter int unsigned Channel = 0
) (
  input  logic                                     enable_i,  // low: nobody looks at the value
  input  logic [3:0]                               source_i,
  input  logic [1:0]                               operand_i,
  input  ffgpu_pkg::color_t                        constant_i,
  input  logic [32*ffgpu_pkg::TextureUnits-1:0]    samples_i,  // (0, 0, 0, 255) if not sampled
  input  ffgpu_pkg::color_t                        primary_i,
  input  ffgpu_pkg::color_t                        previous_i,
  output ffgpu_pkg::channel_t                      value_o
);

  ffgpu_pkg::color_t color;

  always_comb begin
    color   = 32'd0;
    value_o = 8'd0;
    if (enable_i) begin
      unique case (source_i)
        ffgpu_registers_pkg::CombineSourceConstant: color = constant_i;
        ffgpu_registers_pkg::CombineSourcePrimary:  color = primary_i;
        ffgpu_registers_pkg::CombineSourcePrevious: color = previous_i;
        ffgpu_registers_pkg::CombineSourceOne:      color = 32'hffff_ffff;
        default: color = source_i[3] ? 32'd0 : samples_i[{source_i[2:0], 5'd0} +: 32];
      endcase

      // Operands: colour, one minus it, alpha, one minus it.
      value_o = operand_i[1] ? color[31:24] : color[8*Channel +: 8];
      if (operand_i[0]) begin
        value_o = ~value_o;
      end
    end
  end

endmodule
