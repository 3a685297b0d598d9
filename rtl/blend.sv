// The last stage: blends a quad with the pixels of a colour target, or combines it by a logic
// operation, and says what is to be stored.
//
// Latency 3, one quad a cycle: factors; blended colours; pixels. Equals ffgpu::written_color() in
// model/fragment/color_target.cpp, and blend() in blend.cpp. The pixels have been read, and no quad
// before this one has yet to write them: docs/rtl.md says who sees to that.

module blend (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_pkg::blend_state_t  state_0_i,
  input  ffgpu_pkg::blend_state_t  state_1_i,

  input  logic                     in_valid_i,
  output logic                     in_ready_o,
  input  ffgpu_pkg::target_quad_t  in_data_i,

  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output ffgpu_pkg::written_quad_t out_data_o
);

  ffgpu_pkg::factored_quad_t   factored_d, factored_q;
  ffgpu_pkg::target_quad_t     blended_d, blended_q;
  ffgpu_pkg::written_quad_t    written_d;
  logic                        factored_valid, factored_ready, blended_valid, blended_ready;

  // Stage 1: the pixels' colours and the factors.
  ffgpu_pkg::blend_state_t     state_1;
  ffgpu_registers_pkg::blend_t blend_1;
  ffgpu_pkg::quad_t            quad_1;
  logic [127:0]                destination, source_factors, destination_factors;

  assign quad_1  = in_data_i.quad;
  assign state_1 = quad_1.tag ? state_1_i : state_0_i;
  assign blend_1 = ffgpu_registers_pkg::decode_blend(state_1.blend);

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_factors
    pixel_unpack u_unpack (
      .format_i(state_1.format),
      .pixel_i (in_data_i.pixels[32*lane +: 32]),
      .color_o (destination[32*lane +: 32])
    );
    blend_factors u_factors (
      .enable_i             (in_valid_i && in_ready_o),
      .state_i              (blend_1),
      .source_i             (quad_1.color[32*lane +: 32]),
      .destination_i        (destination[32*lane +: 32]),
      .source_factors_o     (source_factors[32*lane +: 32]),
      .destination_factors_o(destination_factors[32*lane +: 32])
    );
  end

  assign factored_d = {quad_1, in_data_i.pixels, destination, source_factors,
                       destination_factors};

  pipeline_register #(
    .Width($bits(factored_d))
  ) u_factored (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i  (factored_d),
    .out_valid_o(factored_valid),
    .out_ready_i(factored_ready),
    .out_data_o (factored_q)
  );

  // Stage 2: products, sum, clamp, rounding.
  ffgpu_pkg::blend_state_t     state_2;
  ffgpu_registers_pkg::blend_t blend_2;
  ffgpu_pkg::quad_t            quad_2;
  logic                        blends;
  logic [127:0]                blended;

  assign quad_2  = factored_q.quad;
  assign state_2 = quad_2.tag ? state_1_i : state_0_i;
  assign blend_2 = ffgpu_registers_pkg::decode_blend(state_2.blend);
  assign blends  = blend_2.enable && !blend_2.logic_op_enable;

  for (genvar channel = 0; channel < 4 * ffgpu_pkg::Lanes; channel++) begin : g_channel
    blend_channel u_channel (
      .enable_i            (factored_valid && factored_ready && blends),
      .equation_i          (channel % 4 == 3 ? blend_2.alpha_equation : blend_2.rgb_equation),
      .source_i            (quad_2.color[8*channel +: 8]),
      .source_factor_i     (factored_q.source_factors[8*channel +: 8]),
      .destination_i       (factored_q.destination[8*channel +: 8]),
      .destination_factor_i(factored_q.destination_factors[8*channel +: 8]),
      .result_o            (blended[8*channel +: 8])
    );
  end

  always_comb begin
    blended_d.quad   = quad_2;
    blended_d.pixels = factored_q.pixels;
    if (blends) begin
      blended_d.quad.color = blended;
    end
  end

  pipeline_register #(
    .Width($bits(blended_d))
  ) u_blended (
    .clk_i,
    .rst_ni,
    .in_valid_i (factored_valid),
    .in_ready_o (factored_ready),
    .in_data_i  (blended_d),
    .out_valid_o(blended_valid),
    .out_ready_i(blended_ready),
    .out_data_o (blended_q)
  );

  // Stage 3: the target's precision, logic operation, mask.
  ffgpu_pkg::blend_state_t                state_3;
  ffgpu_registers_pkg::blend_t            blend_3;
  ffgpu_registers_pkg::fragment_control_t control_3;
  ffgpu_pkg::quad_t                       quad_3;
  logic [127:0]                           pixels;
  logic [15:0]                            enables;

  assign quad_3    = blended_q.quad;
  assign state_3   = quad_3.tag ? state_1_i : state_0_i;
  assign blend_3   = ffgpu_registers_pkg::decode_blend(state_3.blend);
  assign control_3 = ffgpu_registers_pkg::decode_fragment_control(state_3.control);

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_write
    logic [3:0] lane_enables;

    // A quad begins at even coordinates.
    color_write u_write (
      .enable_i (blended_valid && blended_ready),
      .state_i  (blend_3),
      .format_i (state_3.format),
      .dither_i (control_3.dither),
      .color_i  (quad_3.color[32*lane +: 32]),
      .stored_i (blended_q.pixels[32*lane +: 32]),
      .x_i      ({quad_3.x[1], 1'(lane % 2)}),
      .y_i      ({quad_3.y[1], 1'(lane / 2)}),
      .pixel_o  (pixels[32*lane +: 32]),
      .enables_o(lane_enables)
    );
    assign enables[4*lane +: 4] = quad_3.live[lane] ? lane_enables : 4'd0;
  end

  assign written_d = {quad_3, pixels, enables};

  pipeline_register #(
    .Width($bits(written_d))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (blended_valid),
    .in_ready_o (blended_ready),
    .in_data_i  (written_d),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
