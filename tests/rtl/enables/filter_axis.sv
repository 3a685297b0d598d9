bind filter_axis enable_checker u_enable_checker (
  .clk_i,
  .rst_ni,
  .enable_i (g_pair[0].u_lerp.enable_i),
  .goes_on_i(in_valid_i && in_ready_o)
);
