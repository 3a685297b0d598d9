// The division by 255 of products of two channels, to nearest: 255 is odd, so there are no halves.
// And the one rounded down, where its quotient is a channel's.
// Refused with: ffgpu_pkg: biased = product + 16'd128 -> biased = product + 16'd127
// Refused with: ffgpu_pkg: sum = value + 16'd1 -> sum = value + 16'd0

module divide_255_proof (
  input logic [15:0] value_i
);

  logic [7:0]         nearest, below;
  logic signed [17:0] nearest_rest, below_rest;

  assign nearest      = ffgpu_pkg::divide_255(value_i);
  assign below        = ffgpu_pkg::floor_255(value_i);
  // 255 n is 256 n - n.
  assign nearest_rest = $signed({2'd0, value_i}) - $signed({2'd0, nearest, 8'd0}) +
    $signed({10'd0, nearest});
  assign below_rest   = $signed({2'd0, value_i}) - $signed({2'd0, below, 8'd0}) +
    $signed({10'd0, below});

  always_comb begin
    assert (value_i > 16'd65025 || (nearest_rest >= -18'sd127 && nearest_rest <= 18'sd127));
    assert (value_i >= 16'd65280 || (below_rest >= 18'sd0 && below_rest < 18'sd255));
  end

endmodule
