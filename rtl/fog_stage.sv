// One stage of fog on its way to the factor: a fog_lane a lane, and their register.
//
// Latency 1, one quad a cycle.

module fog_stage #(
  parameter int unsigned Stage = 0
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  ffgpu_pkg::fog_curve_t state_0_i,
  input  ffgpu_pkg::fog_curve_t state_1_i,

  input  logic                  in_valid_i,
  output logic                  in_ready_o,
  input  ffgpu_pkg::fog_quad_t  in_data_i,

  output logic                  out_valid_o,
  input  logic                  out_ready_i,
  output ffgpu_pkg::fog_quad_t  out_data_o
);

  ffgpu_pkg::fog_quad_t           left;
  ffgpu_pkg::fog_curve_t          curve;
  ffgpu_pkg::quad_t               quad;
  logic [ffgpu_pkg::Lanes*32-1:0] values;

  assign quad  = in_data_i.quad;
  assign curve = quad.tag ? state_1_i : state_0_i;
  assign left  = {quad, values};

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_lane
    fog_lane #(
      .Stage(Stage)
    ) u_lane (
      .enable_i(in_valid_i && in_ready_o),
      .curve_i (curve),
      .value_i (in_data_i.values[32*lane +: 32]),
      .value_o (values[32*lane +: 32])
    );
  end

  pipeline_register #(
    .Width($bits(left))
  ) u_left (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(left),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
