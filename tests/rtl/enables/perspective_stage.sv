bind perspective_stage enable_checker u_enable_checker (
  .clk_i,
  .rst_ni,
  .enable_i (g_lane[0].u_lane.enable_i),
  .goes_on_i(in_valid_i && in_ready_o)
);
