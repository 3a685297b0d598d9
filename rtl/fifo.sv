// A queue in a memory.
//
// Latency 1, one item a cycle. Depth is a power of two. Ready and valid are flops' alone.

module fifo #(
  parameter int unsigned Width = 8,
  parameter int unsigned Depth = 8
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

  localparam int unsigned IndexWidth = $clog2(Depth);

  logic [Width-1:0]    items_q [Depth];
  logic [IndexWidth:0] read_q, write_q;  // With a bit more, which tells full from empty.
  logic                enters, leaves;

  assign out_valid_o = read_q != write_q;
  assign in_ready_o  = read_q != {~write_q[IndexWidth], write_q[IndexWidth-1:0]};
  assign out_data_o  = items_q[read_q[IndexWidth-1:0]];
  assign enters      = in_valid_i && in_ready_o;
  assign leaves      = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      read_q  <= '0;
      write_q <= '0;
    end else begin
      read_q  <= read_q + {{IndexWidth{1'b0}}, leaves};
      write_q <= write_q + {{IndexWidth{1'b0}}, enters};
    end
  end
  always_ff @(posedge clk_i) begin
    if (enters) begin
      items_q[write_q[IndexWidth-1:0]] <= in_data_i;
    end
  end

endmodule
