bind texture_environment enable_checker u_enable_checker_dot (
  .clk_i,
  .rst_ni,
  .enable_i (g_operations[0].u_dot.enable_i),
  .goes_on_i(argument_valid && argument_ready && is_dot)
);
bind texture_environment enable_checker u_enable_checker_finish (
  .clk_i,
  .rst_ni,
  .enable_i (g_finish[0].u_finish.enable_i),
  .goes_on_i(doubled_valid && doubled_ready)
);
