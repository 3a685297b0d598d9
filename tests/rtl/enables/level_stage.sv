bind level_stage enable_checker u_enable_checker (
  .clk_i,
  .rst_ni,
  .enable_i (g_element[0].u_step.enable_i),
  .goes_on_i(in_valid_i && in_ready_o)
);
// Images have a texel at least.
bind level_stage enable_checker u_enable_checker_densities (
  .clk_i,
  .rst_ni,
  .enable_i (densities != '0),
  .goes_on_i(in_valid_i && in_ready_o)
);
