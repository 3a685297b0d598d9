bind texel_stage enable_checker u_enable_checker (
  .clk_i,
  .rst_ni,
  .enable_i (g_axis[0].u_axis.enable_i),
  .goes_on_i(in_valid_i && in_ready_o)
);
bind texel_stage enable_checker u_enable_checker_rule (
  .clk_i,
  .rst_ni,
  .enable_i (g_axis[0].u_rule.enable_i),
  .goes_on_i(HasRule && in_valid_i && in_ready_o)
);
