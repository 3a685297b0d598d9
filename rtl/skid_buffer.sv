// A stage of a pipe whose ready is a flop: where a chain of ready gates would be too long.
//
// Latency 1, one item a cycle. Holds two items: the one that it offers, and the one that was on its
// way when the next stage stopped.

module skid_buffer #(
  parameter int unsigned Width = 8
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [Width-1:0] in_data_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [Width-1:0] out_data_o
);

  logic             valid_q, spare_valid_q;
  logic [Width-1:0] data_q, spare_q;
  logic             advance;

  assign advance     = out_ready_i || !valid_q;
  assign in_ready_o  = !spare_valid_q;
  assign out_valid_o = valid_q;
  assign out_data_o  = data_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q       <= 1'b0;
      spare_valid_q <= 1'b0;
    end else if (advance) begin
      valid_q       <= spare_valid_q || in_valid_i;
      spare_valid_q <= 1'b0;
    end else if (in_valid_i) begin
      spare_valid_q <= 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (advance) begin
      data_q <= spare_valid_q ? spare_q : in_data_i;
    end
    if (!advance && in_ready_o) begin
      spare_q <= in_data_i;
    end
  end

endmodule
