// Whether quads of a tag are inside the pipe: found by the walker, and not ended at a target.
//
// A draw is done when its last primitive has been walked and none of its quads is left; then its
// tag's registers may change.

module draw_tracker (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       walking_i,  // a primitive of the tag
  input  logic       found_i,
  input  logic       tag_i,
  input  logic [2:0] ends_0_i,
  input  logic [2:0] ends_1_i,
  input  logic [1:0] waits_i,    // stores, by tags

  output logic [1:0] idle_o
);

  localparam int unsigned Width = 12;  // more quads than the pipe can hold

  logic [Width-1:0] count_0_q, count_1_q;
  logic             found_0, found_1;

  assign found_0 = found_i && !tag_i;
  assign found_1 = found_i && tag_i;
  assign idle_o  = {count_1_q == '0 && !(walking_i && tag_i) && !waits_i[1],
                    count_0_q == '0 && !(walking_i && !tag_i) && !waits_i[0]};

  function automatic logic [Width-1:0] ones(input logic [2:0] bits);
    ones = Width'(bits[0]) + Width'(bits[1]) + Width'(bits[2]);
  endfunction

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      count_0_q <= '0;
      count_1_q <= '0;
    end else begin
      count_0_q <= count_0_q + Width'(found_0) - ones(ends_0_i);
      count_1_q <= count_1_q + Width'(found_1) - ones(ends_1_i);
    end
  end

endmodule
