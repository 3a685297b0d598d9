// The sum of two binary32 numbers, rounded to nearest even.
//
// Combinational. Zeros and normal numbers only, whose sum is one of them: the range rule
// (model/arith/range.h) sees to it that nothing on the fragment path is subnormal, infinite or NaN.

module float_add (
  input  logic              enable_i,  // low: nobody looks at the sum, which is 0
  input  ffgpu_pkg::float_t a_i,
  input  ffgpu_pkg::float_t b_i,
  output ffgpu_pkg::float_t sum_o
);

  logic        swaps, sticky, rounds_up;
  logic [31:0] greater, lesser;
  logic [7:0]  distance, exponent;
  logic [26:0] greater_mantissa, lesser_mantissa, shifted, kept;  // with three bits below
  logic [27:0] addend, sum, normal;
  logic [4:0]  leading;
  logic [24:0] rounded;

  always_comb begin
    swaps            = 1'd0;
    sticky           = 1'd0;
    rounds_up        = 1'd0;
    greater          = 32'd0;
    lesser           = 32'd0;
    distance         = 8'd0;
    exponent         = 8'd0;
    greater_mantissa = 27'd0;
    lesser_mantissa  = 27'd0;
    shifted          = 27'd0;
    kept             = 27'd0;
    addend           = 28'd0;
    sum              = 28'd0;
    normal           = 28'd0;
    leading          = 5'd0;
    rounded          = 25'd0;
    sum_o            = 32'd0;
    if (enable_i) begin
      // The greater magnitude first.
      swaps    = a_i[30:0] < b_i[30:0];
      greater  = swaps ? b_i : a_i;
      lesser   = swaps ? a_i : b_i;
      distance = greater[30:23] - lesser[30:23];

      greater_mantissa = greater[30:23] == 8'd0 ? 27'd0 : {1'b1, greater[22:0], 3'd0};
      lesser_mantissa  = lesser[30:23] == 8'd0 ? 27'd0 : {1'b1, lesser[22:0], 3'd0};

      // What is shifted out counts as one bit below the others.
      shifted = distance > 8'd26 ? 27'd0 : lesser_mantissa >> distance[4:0];
      kept    = distance > 8'd26 ? 27'd0 : shifted << distance[4:0];
      sticky  = kept != lesser_mantissa;
      addend  = {1'b0, shifted[26:1], shifted[0] | sticky};
      sum     = greater[31] != lesser[31] ? {1'b0, greater_mantissa} - addend :
        {1'b0, greater_mantissa} + addend;

      // Zeros above the leading bit, and the sum without them.
      normal  = sum;
      leading = 5'd0;
      if (normal[27:12] == 16'd0) begin
        normal     = {normal[11:0], 16'd0};
        leading[4] = 1'b1;
      end
      if (normal[27:20] == 8'd0) begin
        normal     = {normal[19:0], 8'd0};
        leading[3] = 1'b1;
      end
      if (normal[27:24] == 4'd0) begin
        normal     = {normal[23:0], 4'd0};
        leading[2] = 1'b1;
      end
      if (normal[27:26] == 2'd0) begin
        normal     = {normal[25:0], 2'd0};
        leading[1] = 1'b1;
      end
      if (!normal[27]) begin
        normal     = {normal[26:0], 1'b0};
        leading[0] = 1'b1;
      end

      // A sum of 28 bits has its lowest below the three: it stays sticky.
      rounds_up = normal[3] && (normal[2:0] != 3'd0 || normal[4]);
      rounded   = {1'b0, normal[27:4]} + {24'd0, rounds_up};
      exponent  = greater[30:23] + 8'd1 - {3'd0, leading} + {7'd0, rounded[24]};

      // Equal numbers of opposite signs give +0; so does +0 and -0.
      sum_o = sum == 28'd0 ? {greater[31] && lesser[31], 31'd0} :
        {greater[31], exponent, rounded[22:0]};
    end
  end

endmodule
