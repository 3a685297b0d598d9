// From a quad with its samples to its colour: environment_loop, color_sum, fog, apply_coverage,
// alpha_test.

module shading_stages (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  input  ffgpu_pipe_pkg::draw_state_t state_0_i,
  input  ffgpu_pipe_pkg::draw_state_t state_1_i,

  input  logic                        in_valid_i,
  output logic                        in_ready_o,
  input  ffgpu_pkg::shade_quad_t      in_data_i,

  output logic                        out_valid_o,
  input  logic                        out_ready_i,
  output ffgpu_pkg::quad_t            out_data_o
);

  ffgpu_pkg::shade_quad_t combined, summed;
  ffgpu_pkg::quad_t       fogged, covered;
  logic combined_valid, combined_ready, summed_valid, summed_ready, fogged_valid, fogged_ready;
  logic covered_valid, covered_ready;

  environment_loop u_environments (
    .clk_i,
    .rst_ni,
    .combiners_0_i    (state_0_i.combiners),
    .combiners_1_i    (state_1_i.combiners),
    .sampled_units_0_i(state_0_i.sampled_units),
    .sampled_units_1_i(state_1_i.sampled_units),
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o      (combined_valid),
    .out_ready_i      (combined_ready),
    .out_data_o       (combined)
  );
  color_sum u_color_sum (
    .clk_i,
    .rst_ni,
    .state_0_i  (state_0_i.control),
    .state_1_i  (state_1_i.control),
    .in_valid_i (combined_valid),
    .in_ready_o (combined_ready),
    .in_data_i  (combined),
    .out_valid_o(summed_valid),
    .out_ready_i(summed_ready),
    .out_data_o (summed)
  );
  fog u_fog (
    .clk_i,
    .rst_ni,
    .state_0_i  (state_0_i.fog),
    .state_1_i  (state_1_i.fog),
    .in_valid_i (summed_valid),
    .in_ready_o (summed_ready),
    .in_data_i  (summed),
    .out_valid_o(fogged_valid),
    .out_ready_i(fogged_ready),
    .out_data_o (fogged)
  );
  apply_coverage u_coverage (
    .clk_i,
    .rst_ni,
    .in_valid_i (fogged_valid),
    .in_ready_o (fogged_ready),
    .in_data_i  (fogged),
    .out_valid_o(covered_valid),
    .out_ready_i(covered_ready),
    .out_data_o (covered)
  );
  alpha_test u_alpha_test (
    .clk_i,
    .rst_ni,
    .state_0_i  (state_0_i.control),
    .state_1_i  (state_1_i.control),
    .in_valid_i (covered_valid),
    .in_ready_o (covered_ready),
    .in_data_i  (covered),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
