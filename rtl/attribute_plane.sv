// One attribute at the four fragments of a quad: the plane's integer at the corner, and the other
// lanes' offsets from it.
//
// Latency 2, one quad a cycle: products; lanes. Equals ffgpu::AttributePlane::corner() and
// lane_offsets() in model/raster/attribute_plane.h. Sums are modulo 2^46: set-up has seen to it
// that what is left of them fits 32 bits.

module attribute_plane (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  logic                    in_valid_i,
  output logic                    in_ready_o,
  input  ffgpu_pkg::plane_quad_t  in_data_i,

  output logic                    out_valid_o,
  input  logic                    out_ready_i,
  output ffgpu_pkg::lane_values_t out_data_o
);

  localparam int unsigned Width = 32 + ffgpu_pkg::GuardBits;
  localparam logic [Width-1:0] Half = 46'd8192;

  // Stage 1.
  ffgpu_pkg::plane_corner_t corner_d, corner_q;
  logic                     corner_valid, corner_ready;
  logic [Width-1:0]         x, y, dx, dy, product_x, product_y, corner;

  assign x         = {{31{in_data_i.x[14]}}, in_data_i.x};
  assign y         = {{31{in_data_i.y[14]}}, in_data_i.y};
  assign dx        = {in_data_i.dx[44], in_data_i.dx};
  assign dy        = {in_data_i.dy[44], in_data_i.dy};
  assign product_x = dx * x;
  assign product_y = dy * y;
  assign corner    = {in_data_i.whole, in_data_i.fraction} + product_x + product_y;
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

  // Stage 2: lane offsets are rounded by themselves.
  ffgpu_pkg::plane_quad_t  quad;
  ffgpu_pkg::lane_values_t lanes_d;
  logic [Width-1:0]        step_x, step_y, right, up, diagonal;
  logic [31:0]             base;

  assign quad     = corner_q.quad;
  assign step_x   = {quad.dx[44], quad.dx};
  assign step_y   = {quad.dy[44], quad.dy};
  assign right    = step_x + Half;
  assign up       = step_y + Half;
  assign diagonal = step_x + step_y + Half;
  assign base     = corner_q.corner[Width-1:ffgpu_pkg::GuardBits];
  assign lanes_d  = {quad.tag, quad.place,
                     base + diagonal[Width-1:ffgpu_pkg::GuardBits],
                     base + up[Width-1:ffgpu_pkg::GuardBits],
                     base + right[Width-1:ffgpu_pkg::GuardBits],
                     base};

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
