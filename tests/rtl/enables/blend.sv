bind blend enable_checker u_enable_checker_factors (
  .clk_i,
  .rst_ni,
  .enable_i (g_factors[0].u_factors.enable_i),
  .goes_on_i(in_valid_i && in_ready_o)
);
bind blend enable_checker u_enable_checker_channel (
  .clk_i,
  .rst_ni,
  .enable_i (g_channel[0].u_channel.enable_i),
  .goes_on_i(factored_valid && factored_ready && blends)
);
bind blend enable_checker u_enable_checker_write (
  .clk_i,
  .rst_ni,
  .enable_i (g_write[0].u_write.enable_i),
  .goes_on_i(blended_valid && blended_ready)
);
