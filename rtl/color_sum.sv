// The colour sum: adds the secondary colour, clamped, and leaves alpha.
//
// Latency 1, one quad a cycle. Equals ffgpu::add_secondary() in model/fragment/color_sum.h.

module color_sum (
  input  logic                                         clk_i,
  input  logic                                         rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_registers_pkg::fragment_control_words_t state_0_i,
  input  ffgpu_registers_pkg::fragment_control_words_t state_1_i,

  input  logic                                         in_valid_i,
  output logic                                         in_ready_o,
  input  ffgpu_pkg::shade_quad_t                       in_data_i,

  output logic                                         out_valid_o,
  input  logic                                         out_ready_i,
  output ffgpu_pkg::shade_quad_t                       out_data_o
);

  ffgpu_registers_pkg::fragment_control_t state;
  ffgpu_pkg::quad_t                       quad, summed;
  ffgpu_pkg::shade_quad_t                 shaded;
  logic [ffgpu_pkg::Lanes*32-1:0]         color;

  assign quad = in_data_i.quad;
  assign state = ffgpu_registers_pkg::decode_fragment_control(quad.tag ? state_1_i : state_0_i);

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_lane
    for (genvar channel = 0; channel < 3; channel++) begin : g_channel
      localparam int unsigned At = 32 * lane + 8 * channel;
      localparam int unsigned SecondaryAt = 24 * lane + 8 * channel;
      logic [8:0] sum;
      assign sum = {1'b0, quad.color[At +: 8]} + {1'b0, in_data_i.secondary[SecondaryAt +: 8]};
      assign color[At +: 8] = sum[8] ? 8'd255 : sum[7:0];
    end
    assign color[32*lane+24 +: 8] = quad.color[32*lane+24 +: 8];
  end

  always_comb begin
    summed = quad;
    if (state.color_sum) begin
      summed.color = color;
    end
  end
  assign shaded = {summed, in_data_i.primary, in_data_i.secondary, in_data_i.fog_coordinate,
                   in_data_i.samples};

  pipeline_register #(
    .Width($bits(shaded))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(shaded),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
