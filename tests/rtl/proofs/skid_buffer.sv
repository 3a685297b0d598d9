// A skid buffer keeps the channel's claims (channel_claims.sv).
// For 16 cycles.
// Refused with: skid_buffer: spare_valid_q || in_valid_i -> in_valid_i
// Refused with: skid_buffer: if (!advance && in_ready_o) begin -> if (!advance) begin

module skid_buffer_proof (
  input logic       clk_i,
  input logic       rst_ni,
  input logic       follow_i,
  input logic       in_valid_i,
  input logic [1:0] in_data_i,
  input logic       out_ready_i
);

  logic       in_ready, out_valid;
  logic [1:0] out_data;

  skid_buffer #(
    .Width(2)
  ) u_skid_buffer (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o (in_ready),
    .in_data_i,
    .out_valid_o(out_valid),
    .out_ready_i,
    .out_data_o (out_data)
  );
  channel_claims #(
    .Width (2),
    .Places(2)
  ) u_claims (
    .clk_i,
    .rst_ni,
    .follow_i,
    .in_valid_i,
    .in_ready_i (in_ready),
    .in_data_i,
    .out_valid_i(out_valid),
    .out_ready_i,
    .out_data_i (out_data)
  );

endmodule
