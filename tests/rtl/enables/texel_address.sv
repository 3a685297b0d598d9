bind texel_address enable_checker u_enable_checker (
  .clk_i,
  .rst_ni,
  .enable_i (g_axis[0].u_pair.enable_i),
  .goes_on_i(valid[Stages] && ready[Stages])
);
