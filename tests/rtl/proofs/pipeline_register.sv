// A stage's register keeps the channel's claims (channel_claims.sv).
// Refused with: pipeline_register: if (in_ready_o && in_valid_i) begin -> if (in_valid_i) begin
// Refused with: pipeline_register: out_ready_i || !valid_q -> 1'b1

module pipeline_register_proof (
  input logic       clk_i,
  input logic       rst_ni,
  input logic       follow_i,
  input logic       in_valid_i,
  input logic [1:0] in_data_i,
  input logic       out_ready_i
);

  logic       in_ready, out_valid;
  logic [1:0] out_data;

  pipeline_register #(
    .Width(2)
  ) u_pipeline_register (
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
    .Width      (2),
    .Places     (1),
    .ReadyIsFlop(1'b0)
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
