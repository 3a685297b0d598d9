// One step of a quad through the division by w or q: a perspective_lane a lane, and their register.
//
// Latency 1, one quad a cycle.

module perspective_stage #(
  parameter int unsigned Stage = 0
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         in_valid_i,
  output logic                         in_ready_o,
  input  ffgpu_pkg::perspective_quad_t in_data_i,

  output logic                         out_valid_o,
  input  logic                         out_ready_i,
  output ffgpu_pkg::perspective_quad_t out_data_o
);

  ffgpu_pkg::perspective_quad_t left;
  logic [127:0]                 values;

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_lane
    perspective_lane #(
      .Stage(Stage),
      .Lane (lane)
    ) u_lane (
      .enable_i(in_valid_i && in_ready_o),
      .quad_i  (in_data_i),
      .value_o (values[32*lane +: 32])
    );
  end

  always_comb begin
    left        = in_data_i;
    left.values = values;
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
