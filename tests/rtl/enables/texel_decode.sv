bind texel_decode enable_checker u_enable_checker_color (
  .clk_i,
  .rst_ni,
  .enable_i (u_s3tc_color.enable_i),
  .goes_on_i(in_valid_i && in_ready_o && is_s3tc)
);
bind texel_decode enable_checker u_enable_checker_alpha (
  .clk_i,
  .rst_ni,
  .enable_i (u_s3tc_alpha.enable_i),
  .goes_on_i(in_valid_i && in_ready_o && is_s3tc && !is_dxt1)
);
bind texel_decode enable_checker u_enable_checker_fxt1 (
  .clk_i,
  .rst_ni,
  .enable_i (u_fxt1.enable_i),
  .goes_on_i(in_valid_i && in_ready_o && is_fxt1)
);
