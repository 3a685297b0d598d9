// The two factors of each channel of a fragment. Factors beyond the list are zero.
//
// Combinational. Equals factor_value() in model/fragment/blend.cpp.

module blend_factors (
  input  logic                        enable_i,  // low: nobody looks at the factors
  input  ffgpu_registers_pkg::blend_t state_i,
  input  ffgpu_pkg::color_t           source_i,
  input  ffgpu_pkg::color_t           destination_i,
  output ffgpu_pkg::color_t           source_factors_o,
  output ffgpu_pkg::color_t           destination_factors_o
);

  logic [7:0] source_alpha, destination_alpha, saturated;

  assign source_alpha      = source_i[31:24];
  assign destination_alpha = destination_i[31:24];
  assign saturated =
    source_alpha < ~destination_alpha ? source_alpha : ~destination_alpha;

  for (genvar channel = 0; channel < 4; channel++) begin : g_channel
    localparam int unsigned At = 8 * channel;
    for (genvar side = 0; side < 2; side++) begin : g_side
      ffgpu_registers_pkg::blend_factor_e factor;
      logic [7:0]                         value;

      if (side == 0) begin : g_source
        assign factor = channel == 3 ? state_i.alpha_source : state_i.rgb_source;
        assign source_factors_o[At +: 8] = value;
      end else begin : g_destination
        assign factor = channel == 3 ? state_i.alpha_destination : state_i.rgb_destination;
        assign destination_factors_o[At +: 8] = value;
      end

      always_comb begin
        value = 8'd0;
        if (enable_i) begin
          unique case (factor)
            ffgpu_registers_pkg::BlendFactorZero:             value = 8'd0;
            ffgpu_registers_pkg::BlendFactorOne:              value = 8'd255;
            ffgpu_registers_pkg::BlendFactorSourceColor:      value = source_i[At +: 8];
            ffgpu_registers_pkg::BlendFactorDestinationColor: value = destination_i[At +: 8];
            ffgpu_registers_pkg::BlendFactorConstantColor:    value = state_i.constant[At +: 8];
            ffgpu_registers_pkg::BlendFactorSourceAlpha:      value = source_alpha;
            ffgpu_registers_pkg::BlendFactorDestinationAlpha: value = destination_alpha;
            ffgpu_registers_pkg::BlendFactorConstantAlpha:    value = state_i.constant[31:24];
            ffgpu_registers_pkg::BlendFactorOneMinusSourceColor: value = ~source_i[At +: 8];
            ffgpu_registers_pkg::BlendFactorOneMinusDestinationColor:
              value = ~destination_i[At +: 8];
            ffgpu_registers_pkg::BlendFactorOneMinusConstantColor:
              value = ~state_i.constant[At +: 8];
            ffgpu_registers_pkg::BlendFactorOneMinusSourceAlpha: value = ~source_alpha;
            ffgpu_registers_pkg::BlendFactorOneMinusDestinationAlpha: value = ~destination_alpha;
            ffgpu_registers_pkg::BlendFactorOneMinusConstantAlpha:
              value = ~state_i.constant[31:24];
            ffgpu_registers_pkg::BlendFactorSourceAlphaSaturate:
              value = channel == 3 ? 8'd255 : saturated;
            default: value = 8'd0;
          endcase
        end
      end
    end
  end

endmodule
