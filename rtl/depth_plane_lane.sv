// A depth with 24 fraction bits, rounded to nearest and clamped to its primitive's range.
//
// Combinational. Equals what depth_beside() in model/raster/interpolator.cpp does after the sum.

module depth_plane_lane (
  input  logic [63:0]       sum_i,  // signed
  input  ffgpu_pkg::depth_t depth_min_i,
  input  ffgpu_pkg::depth_t depth_max_i,
  output ffgpu_pkg::depth_t depth_o
);

  localparam logic [63:0] Half = 64'd8388608;

  logic [63:0] rounded;
  logic        negative, above;

  assign rounded  = sum_i + Half;
  assign negative = rounded[63];
  assign above    = rounded[62:48] != 15'd0 || rounded[47:24] > depth_max_i;

  always_comb begin
    depth_o = rounded[47:24] < depth_min_i ? depth_min_i : rounded[47:24];
    if (above) begin
      depth_o = depth_max_i;
    end
    if (negative) begin
      depth_o = depth_min_i;
    end
  end

endmodule
