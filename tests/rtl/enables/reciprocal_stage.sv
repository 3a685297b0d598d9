// What divides changes nothing that passes it in other cycles.
bind reciprocal_stage enable_checker u_enable_checker (
  .clk_i,
  .rst_ni,
  .enable_i (in_valid_i && in_ready_o || bits != '0 || remainder != in_data_i.remainder),
  .goes_on_i(in_valid_i && in_ready_o)
);
