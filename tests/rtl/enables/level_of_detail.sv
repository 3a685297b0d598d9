bind level_of_detail enable_checker u_enable_checker (
  .clk_i,
  .rst_ni,
  .enable_i (u_probes.enable_i),
  .goes_on_i(valid[Stages] && ready[Stages])
);
