// Twice the dot product of two colours, each channel n standing for 2 n - 255, as combine_operation
// gives its results: 2 sum((2 a0 - 255) (2 a1 - 255)) over r, g, b.
//
// Combinational. Equals doubled_dot_product() in model/fragment/texture_environment.cpp.

module combine_dot (
  input  logic                               enable_i,  // low: nobody looks at the result
  input  logic [95:0]                        arguments_i,  // of r, g, b; argument 0 lowest
  output logic [ffgpu_pkg::DoubledWidth-1:0] doubled_o
);

  logic signed [17:0] a, b, product;
  logic signed [19:0] sum;

  always_comb begin
    a       = 18'sd0;
    b       = 18'sd0;
    product = 18'sd0;
    sum     = 20'sd0;
    if (enable_i) begin
      for (int unsigned channel = 0; channel < 3; channel++) begin
        // 2 n - 255 is 2 n + 1 less 256.
        a       = $signed({9'd0, arguments_i[32*channel +: 8], 1'b1}) - 18'sd256;
        b       = $signed({9'd0, arguments_i[32*channel+8 +: 8], 1'b1}) - 18'sd256;
        product = a * b;
        sum     = sum + $signed({{2{product[17]}}, product});
      end
    end
  end
  assign doubled_o = {sum[18:0], 1'b0};

endmodule
