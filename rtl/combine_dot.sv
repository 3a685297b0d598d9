// Twice the dot product of two colours, each channel n standing for 2 n - 255, as combine_operation
// gives its results: 2 sum((2 a0 - 255) (2 a1 - 255)) over r, g, b.
//
// Combinational. Equals dot_product() in model/fragment/texture_environment.cpp before its finish.

module combine_dot (
  input  logic [95:0]                        arguments_i,  // of r, g, b; argument 0 lowest
  output logic [ffgpu_pkg::DoubledWidth-1:0] doubled_o
);

  logic [3*18-1:0]    products;
  logic signed [19:0] sum;

  for (genvar channel = 0; channel < 3; channel++) begin : g_channel
    logic signed [17:0] a, b, product;
    // 2 n - 255 is 2 n + 1 less 256.
    assign a = $signed({9'd0, arguments_i[32*channel +: 8], 1'b1}) - 18'sd256;
    assign b = $signed({9'd0, arguments_i[32*channel+8 +: 8], 1'b1}) - 18'sd256;
    assign product = a * b;
    assign products[18*channel +: 18] = product;
  end

  assign sum = $signed({{2{products[17]}}, products[17:0]}) +
    $signed({{2{products[35]}}, products[35:18]}) + $signed({{2{products[53]}}, products[53:36]});
  assign doubled_o = {sum[18:0], 1'b0};

endmodule
