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
bind texture_environment enable_checker u_enable_checker_samples (
  .clk_i,
  .rst_ni,
  .enable_i (in_valid_i && in_ready_o || g_arguments[0].samples != '0),
  .goes_on_i(in_valid_i && in_ready_o)
);
bind texture_environment enable_checker u_enable_checker_argument (
  .clk_i,
  .rst_ni,
  .enable_i (g_arguments[0].g_slot[0].u_argument.enable_i),
  .goes_on_i(in_valid_i && in_ready_o)
);
bind texture_environment enable_checker u_enable_checker_operation (
  .clk_i,
  .rst_ni,
  .enable_i (g_operations[0].g_channel[0].u_operation.enable_i),
  .goes_on_i(argument_valid && argument_ready)
);
