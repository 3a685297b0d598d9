// The depths of a quad's fragments from their primitive's plane, which is exact: integers modulo
// 2^64, rounded once.
//
// Latency 2, one quad a cycle: the corner's sum; lanes. Equals ffgpu::interpolate_depth_scalar() in
// model/raster/interpolator.cpp.

module depth_plane (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         in_valid_i,
  output logic                         in_ready_o,
  input  ffgpu_pkg::depth_plane_quad_t in_data_i,

  output logic                         out_valid_o,
  input  logic                         out_ready_i,
  output ffgpu_pkg::lane_depths_t      out_data_o
);

  // Stage 1.
  ffgpu_pkg::depth_corner_t corner_d, corner_q;
  logic                     corner_valid, corner_ready;
  logic [63:0]              x, y, product_x, product_y, corner;

  assign x         = {{49{in_data_i.x[14]}}, in_data_i.x};
  assign y         = {{49{in_data_i.y[14]}}, in_data_i.y};
  assign product_x = in_data_i.dx * x;
  assign product_y = in_data_i.dy * y;
  assign corner    = in_data_i.origin + product_x + product_y;
  assign corner_d  = {in_data_i, corner};

  pipeline_register #(
    .Width($bits(corner_d))
  ) u_corner (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i  (corner_d),
    .out_valid_o(corner_valid),
    .out_ready_i(corner_ready),
    .out_data_o (corner_q)
  );

  // Stage 2.
  ffgpu_pkg::depth_plane_quad_t quad;
  ffgpu_pkg::lane_depths_t      lanes_d;
  logic [4*64-1:0]              sums;
  logic [4*24-1:0]              depths;

  assign quad = corner_q.quad;
  assign sums = {corner_q.corner + quad.dx + quad.dy, corner_q.corner + quad.dy,
                 corner_q.corner + quad.dx, corner_q.corner};

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_lane
    depth_plane_lane u_lane (
      .sum_i      (sums[64*lane +: 64]),
      .depth_min_i(quad.depth_min),
      .depth_max_i(quad.depth_max),
      .depth_o    (depths[24*lane +: 24])
    );
  end

  assign lanes_d = {quad.tag, quad.place, depths};

  pipeline_register #(
    .Width($bits(lanes_d))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (corner_valid),
    .in_ready_o (corner_ready),
    .in_data_i  (lanes_d),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
