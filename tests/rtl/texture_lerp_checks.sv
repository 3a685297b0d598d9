bind texture_lerp channel_checker #(
  .Width(ffgpu_pkg::ChannelWidth)
) out_checker (
  .clk_i  (clk_i),
  .rst_ni (rst_ni),
  .valid_i(out_valid_o),
  .ready_i(out_ready_i),
  .data_i (out_value_o)
);
