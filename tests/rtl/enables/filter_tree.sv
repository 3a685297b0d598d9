bind filter_tree enable_checker u_enable_checker_mean (
  .clk_i,
  .rst_ni,
  .enable_i (g_channel[0].u_mean.enable_i),
  .goes_on_i(level_valid && level_ready && level.last_level && level.last_probe)
);
bind filter_tree enable_checker u_enable_checker_levels (
  .clk_i,
  .rst_ni,
  .enable_i (u_levels.enable_i),
  .goes_on_i(level_valid && level_ready)
);
