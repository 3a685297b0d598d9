// The mean of up to sixteen channels, halves up, by a multiplication.
// Refused with: filter_mean: 17'd5042 -> 17'd5041
// Refused with: filter_mean: 17'd4370 -> 17'd4372

module filter_mean_proof (
  input logic [11:0] sum_i,
  input logic [4:0]  count_i
);

  logic [7:0]  mean;
  logic [12:0] product, biased;

  filter_mean u_mean (
    .enable_i(1'b1),
    .sum_i,
    .count_i,
    .mean_o  (mean)
  );
  assign product = {5'd0, mean} * {8'd0, count_i};
  assign biased  = {1'b0, sum_i} + {9'd0, count_i[4:1]};

  always_comb begin
    assume (count_i >= 5'd1 && count_i <= 5'd16);
    assume ({1'b0, sum_i} <= 13'd255 * {8'd0, count_i});
    assert (product <= biased && biased < product + {8'd0, count_i});
  end

endmodule
