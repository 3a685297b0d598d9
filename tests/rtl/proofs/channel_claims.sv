// What every register and queue of a channel does, whatever its neighbours do: what is offered
// stays until it is taken, nothing is lost, doubled or reordered, and there is room until all
// places are taken. Any one item is followed on its way: how many are before it, and what it is.

module channel_claims #(
  parameter int unsigned Width = 2,
  parameter int unsigned Places = 1,
  parameter bit          ReadyIsFlop = 1'b1  // else it sees the receiver's
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             follow_i,  // the item that enters now, if none is followed
  input logic             in_valid_i,
  input logic             in_ready_i,
  input logic [Width-1:0] in_data_i,
  input logic             out_valid_i,
  input logic             out_ready_i,
  input logic [Width-1:0] out_data_i
);

  logic             begun_q = 1'b0;  // There has been a reset.
  logic [3:0]       inside_q, before_q;
  logic             follows_q, offered_q;
  logic [Width-1:0] item_q, data_q;
  logic             enters, leaves, begins;

  assign enters = in_valid_i && in_ready_i;
  assign leaves = out_valid_i && out_ready_i;
  assign begins = enters && follow_i && !follows_q;

  always_ff @(posedge clk_i) begin
    begun_q   <= 1'b1;
    inside_q  <= rst_ni ? inside_q + {3'd0, enters} - {3'd0, leaves} : 4'd0;
    offered_q <= rst_ni && out_valid_i && !out_ready_i;
    data_q    <= out_data_i;
    if (!rst_ni) begin
      follows_q <= 1'b0;
    end else if (begins) begin
      follows_q <= 1'b1;
      before_q  <= inside_q - {3'd0, leaves};
      item_q    <= in_data_i;
    end else if (follows_q && leaves) begin
      follows_q <= before_q != 4'd0;
      before_q  <= before_q - 4'd1;
    end
  end

  always_comb begin
    assume (begun_q || !rst_ni);
    if (begun_q && rst_ni) begin
      assert (inside_q <= Places);
      assert (!offered_q || (out_valid_i && out_data_i == data_q));
      assert (out_valid_i == (inside_q != 4'd0));
      assert (in_ready_i == (inside_q < Places || (!ReadyIsFlop && out_ready_i)));
      assert (!follows_q || before_q < inside_q);
      assert (!(follows_q && before_q == 4'd0) || out_data_i == item_q);
    end
  end

endmodule
