// The sum of two binary32 numbers, rounded to nearest even.
//
// Combinational. Zeros and normal numbers only, whose sum is one of them: the range rule
// (model/arith/range.h) sees to it that nothing on the fragment path is subnormal, infinite or NaN.

module float_add (
  input  ffgpu_pkg::float_t a_i,
  input  ffgpu_pkg::float_t b_i,
  output ffgpu_pkg::float_t sum_o
);

  logic              swaps, subtracts, sticky, rounds_up;
  ffgpu_pkg::float_t greater, lesser;
  logic [7:0]        distance, exponent;
  logic [26:0]       greater_mantissa, lesser_mantissa, shifted, kept;  // with three bits below
  logic [27:0]       sum, normal;
  logic [4:0]        leading;
  logic [24:0]       rounded;

  // The greater magnitude first.
  assign swaps     = a_i[30:0] < b_i[30:0];
  assign greater     = swaps ? b_i : a_i;
  assign lesser     = swaps ? a_i : b_i;
  assign subtracts = greater[31] != lesser[31];
  assign distance  = greater[30:23] - lesser[30:23];

  assign greater_mantissa = greater[30:23] == 8'd0 ? 27'd0 : {1'b1, greater[22:0], 3'd0};
  assign lesser_mantissa = lesser[30:23] == 8'd0 ? 27'd0 : {1'b1, lesser[22:0], 3'd0};

  // What is shifted out counts as one bit below the others.
  assign shifted = distance > 8'd26 ? 27'd0 : lesser_mantissa >> distance[4:0];
  assign kept    = distance > 8'd26 ? 27'd0 : shifted << distance[4:0];
  assign sticky  = kept != lesser_mantissa;

  assign sum = subtracts ?
    {1'b0, greater_mantissa} - {1'b0, shifted[26:1], shifted[0] | sticky} :
    {1'b0, greater_mantissa} + {1'b0, shifted[26:1], shifted[0] | sticky};

  // Zeros above the leading bit of `sum`.
  always_comb begin
    leading = 5'd28;
    for (int unsigned i = 0; i < 28; i++) begin
      if (sum[i]) begin
        leading = 5'd27 - i[4:0];
      end
    end
  end

  // A sum of 28 bits has its lowest below the three: it stays sticky.
  assign normal    = leading == 5'd0 ? sum : sum << leading;
  assign rounds_up = normal[3] && (normal[2:0] != 3'd0 || normal[4]);
  assign rounded   = {1'b0, normal[27:4]} + {24'd0, rounds_up};
  assign exponent  = greater[30:23] + 8'd1 - {3'd0, leading} + {7'd0, rounded[24]};

  // Equal numbers of opposite signs give +0; so does +0 and -0.
  always_comb begin
    sum_o = {greater[31], exponent, rounded[22:0]};
    if (sum == 28'd0) begin
      sum_o = {greater[31] && lesser[31], 31'd0};
    end
  end

endmodule
