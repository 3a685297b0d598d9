// The filter: up to eight texels of a level along x, y and z, then two levels, then the mean of the
// probes.
//
// Latency 4, one level a cycle; a fragment's color follows its last level. Equals filter_fragment()
// in model/texture/sample.cpp on texels, by ffgpu::lerp8w() in filter.h. A weight of 0 gives the
// first texel itself: a nearest filter, or an axis that the texture has not, has that weight.

module filter_tree (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     in_valid_i,
  output logic                     in_ready_o,
  input  ffgpu_pkg::filter_level_t in_data_i,

  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output ffgpu_pkg::texel_t        out_data_o
);

  ffgpu_pkg::filter_level_t rows, slices, level;
  logic                     rows_valid, rows_ready, slices_valid, slices_ready;
  logic                     level_valid, level_ready;

  filter_axis #(
    .Pairs(4)
  ) u_rows (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o(rows_valid),
    .out_ready_i(rows_ready),
    .out_data_o (rows)
  );
  filter_axis #(
    .Pairs(2)
  ) u_slices (
    .clk_i,
    .rst_ni,
    .in_valid_i (rows_valid),
    .in_ready_o (rows_ready),
    .in_data_i  (rows),
    .out_valid_o(slices_valid),
    .out_ready_i(slices_ready),
    .out_data_o (slices)
  );
  filter_axis #(
    .Pairs(1)
  ) u_level (
    .clk_i,
    .rst_ni,
    .in_valid_i (slices_valid),
    .in_ready_o (slices_ready),
    .in_data_i  (slices),
    .out_valid_o(level_valid),
    .out_ready_i(level_ready),
    .out_data_o (level)
  );

  // A finer level waits for the coarser one; probes add up.
  logic              has_fine_q, has_sum_q, ends, taken, out_ready;
  ffgpu_pkg::color_t fine_q, fine, probe, mean;
  logic [47:0]       sum_q, sum;
  ffgpu_pkg::texel_t texel_d;

  assign ends        = level.last_level && level.last_probe;
  assign level_ready = out_ready || !ends;
  assign taken       = level_valid && level_ready;
  assign fine        = has_fine_q ? fine_q : level.texels[31:0];

  texture_lerp u_levels (
    .enable_i(taken),
    .a_i     (fine),
    .b_i     (level.texels[31:0]),
    .weight_i(level.level_weight),
    .value_o (probe)
  );

  for (genvar channel = 0; channel < 4; channel++) begin : g_channel
    assign sum[12*channel +: 12] = (has_sum_q ? sum_q[12*channel +: 12] : 12'd0) +
      {4'd0, probe[8*channel +: 8]};
    filter_mean u_mean (
      .enable_i(taken && ends),
      .sum_i   (sum[12*channel +: 12]),
      .count_i (level.probes),
      .mean_o  (mean[8*channel +: 8])
    );
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      has_fine_q <= 1'b0;
      has_sum_q  <= 1'b0;
    end else if (taken) begin
      has_fine_q <= !level.last_level;
      has_sum_q  <= !ends && (has_sum_q || level.last_level);
    end
  end
  always_ff @(posedge clk_i) begin
    if (taken) begin
      fine_q <= level.texels[31:0];  // looked at behind a finer level alone
    end
    if (taken && level.last_level) begin
      sum_q <= sum;
    end
  end

  assign texel_d = {level.tag, level.place, mean};

  pipeline_register #(
    .Width($bits(texel_d))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (level_valid && ends),
    .in_ready_o (out_ready),
    .in_data_i  (texel_d),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
