// The product of two binary32 numbers, rounded to nearest even.
//
// Combinational. Zeros and normal numbers only, whose product is one of them: the range rule
// (model/arith/range.h) sees to it that nothing on the fragment path is subnormal, infinite or NaN.

module float_multiply (
  input  logic              enable_i,  // low: nobody looks at the product, which is 0
  input  ffgpu_pkg::float_t a_i,
  input  ffgpu_pkg::float_t b_i,
  output ffgpu_pkg::float_t product_o
);

  logic        is_zero, above_half, ties, rounds_up;
  logic [47:0] product, normal;
  logic [7:0]  exponent;
  logic [24:0] rounded;

  always_comb begin
    is_zero    = 1'd0;
    above_half = 1'd0;
    ties       = 1'd0;
    rounds_up  = 1'd0;
    product    = 48'd0;
    normal     = 48'd0;
    exponent   = 8'd0;
    rounded    = 25'd0;
    product_o  = 32'd0;
    if (enable_i) begin
      is_zero = a_i[30:23] == 8'd0 || b_i[30:23] == 8'd0;
      product = {24'd0, 1'b1, a_i[22:0]} * {24'd0, 1'b1, b_i[22:0]};

      // In [1, 4): the leading bit to the top.
      normal     = product[47] ? product : {product[46:0], 1'b0};
      above_half = normal[23] && normal[22:0] != 23'd0;
      ties       = normal[23] && normal[22:0] == 23'd0;
      rounds_up  = above_half || (ties && normal[24]);
      rounded    = {1'b0, normal[47:24]} + {24'd0, rounds_up};

      // Of a carry the fraction is 0.
      exponent  = a_i[30:23] + b_i[30:23] - 8'd127 + {7'd0, product[47]} + {7'd0, rounded[24]};
      product_o = {a_i[31] ^ b_i[31], is_zero ? 31'd0 : {exponent, rounded[22:0]}};
    end
  end

endmodule
