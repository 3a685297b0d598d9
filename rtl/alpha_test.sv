// The alpha test: a fragment whose alpha fails the comparison with the reference dies.
//
// Latency 1, one quad a cycle. Equals ffgpu::passes_alpha_test() in model/fragment/alpha_test.h.

module alpha_test (
  input  logic                                         clk_i,
  input  logic                                         rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_registers_pkg::fragment_control_words_t state_0_i,
  input  ffgpu_registers_pkg::fragment_control_words_t state_1_i,

  input  logic                                         in_valid_i,
  output logic                                         in_ready_o,
  input  ffgpu_pkg::quad_t                             in_data_i,

  output logic                                         out_valid_o,
  input  logic                                         out_ready_i,
  output ffgpu_pkg::quad_t                             out_data_o
);

  ffgpu_registers_pkg::fragment_control_t state;
  logic [ffgpu_pkg::Lanes-1:0]            passes;
  ffgpu_pkg::quad_t                       quad;

  assign state =
    ffgpu_registers_pkg::decode_fragment_control(in_data_i.tag ? state_1_i : state_0_i);

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_lane
    assign passes[lane] = !state.alpha_test ||
      ffgpu_pkg::compare(state.alpha_compare, {16'd0, in_data_i.color[32*lane+24 +: 8]},
                         {16'd0, state.alpha_reference});
  end

  always_comb begin
    quad      = in_data_i;
    quad.live = in_data_i.live & passes;
  end

  pipeline_register #(
    .Width($bits(quad))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(quad),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
