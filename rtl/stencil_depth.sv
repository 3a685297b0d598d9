// The visit of a quad to the depth target: depth bounds, stencil test, depth test, what is stored.
//
// Latency 1, one quad a cycle. A lane is a stencil_depth_core. The pixels have been read, and no
// quad before this one has yet to write them: docs/rtl.md says who sees to that.

module stencil_depth (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_pkg::stencil_depth_state_t state_0_i,
  input  ffgpu_pkg::stencil_depth_state_t state_1_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pkg::target_quad_t         in_data_i,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output ffgpu_pkg::written_quad_t        out_data_o
);

  ffgpu_pkg::stencil_depth_state_t     state;
  ffgpu_registers_pkg::stencil_t       stencil;
  ffgpu_registers_pkg::depth_control_t depth_control;
  ffgpu_pkg::quad_t                    quad;
  ffgpu_pkg::written_quad_t            written;
  logic [ffgpu_pkg::Lanes-1:0]         passes;
  logic [ffgpu_pkg::Lanes*32-1:0]      pixels;
  logic [ffgpu_pkg::Lanes*4-1:0]       enables;
  logic                                is_depth16;

  assign quad          = in_data_i.quad;
  assign state         = quad.tag ? state_1_i : state_0_i;
  assign stencil       = ffgpu_registers_pkg::decode_stencil(state.stencil);
  assign depth_control = ffgpu_registers_pkg::decode_depth_control(state.depth);
  assign is_depth16    = state.format == ffgpu_registers_pkg::FormatDepth16;

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_lane
    logic writes_depth, writes_stencil;

    stencil_depth_core u_core (
      .stencil_i       (stencil),
      .depth_control_i (depth_control),
      .format_i        (state.format),
      .front_facing_i  (quad.front_facing),
      .depth_i         (quad.depth[24*lane +: 24]),
      .stored_i        (in_data_i.pixels[32*lane +: 32]),
      .passes_o        (passes[lane]),
      .pixel_o         (pixels[32*lane +: 32]),
      .writes_depth_o  (writes_depth),
      .writes_stencil_o(writes_stencil)
    );

    // Depth in bytes 0 and 1 of 16 bits, or 1 to 3 above the stencil.
    assign enables[4*lane +: 4] = !quad.live[lane] ? 4'd0 :
      is_depth16 ? {2'd0, {2{writes_depth}}} : {{3{writes_depth}}, writes_stencil};
  end

  always_comb begin
    written.quad      = quad;
    written.quad.live = quad.live & passes;
    written.pixels    = pixels;
    written.enables   = enables;
  end

  pipeline_register #(
    .Width($bits(written))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(written),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
