// Smooth primitives: alpha times the coverage, rounded to nearest. A coverage of 255 leaves it.
//
// Latency 1, one quad a cycle. Equals ffgpu::apply_coverage() in model/fragment/color_sum.h.

module apply_coverage (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  ffgpu_pkg::quad_t in_data_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output ffgpu_pkg::quad_t out_data_o
);

  ffgpu_pkg::quad_t               covered;
  logic [ffgpu_pkg::Lanes*32-1:0] color;

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_lane
    logic [15:0] alpha, coverage;
    assign alpha    = {8'd0, in_data_i.color[32*lane+24 +: 8]};
    assign coverage = {8'd0, in_data_i.coverage[8*lane +: 8]};
    assign color[32*lane +: 24] = in_data_i.color[32*lane +: 24];
    assign color[32*lane+24 +: 8] = ffgpu_pkg::divide_255(alpha * coverage);
  end

  always_comb begin
    covered       = in_data_i;
    covered.color = color;
  end

  pipeline_register #(
    .Width($bits(covered))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(covered),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
