// One element of one step to the squared sides of a pixel: a difference between lanes, the same in
// texels, its square, and the sums of squares in the place of their first.
//
// Combinational; Stage says which step it is. Equals squared_length() in
// model/texture/level_of_detail.inl.

module level_step #(
  parameter int unsigned Stage = 0,
  parameter int unsigned Element = 0
) (
  input  logic                               enable_i,  // low: nobody looks at the value
  input  ffgpu_texture_pkg::level_operands_t operands_i,
  output ffgpu_pkg::float_t                  value_o
);

  localparam int unsigned Axis = Element % 3;
  localparam int unsigned Other = (Stage == 3 ? Element + 1 : Element + 2) % 6;
  localparam ffgpu_pkg::float_t LeastStep = 32'h2180_0000;  // 2^-60
  localparam ffgpu_pkg::float_t LargestStep = 32'h5d80_0000;  // 2^60

  ffgpu_texture_pkg::level_steps_t steps;
  ffgpu_pkg::float_t       value;
  assign steps = operands_i.steps;
  assign value = steps.values[32*Element +: 32];

  if (Stage == 0) begin : g_difference
    ffgpu_pkg::float_t subtrahend;

    assign subtrahend = steps.steps[32*Element +: 32];
    float_add u_difference (
      .enable_i,
      .a_i  (value),
      .b_i  ({~subtrahend[31], subtrahend[30:0]}),
      .sum_o(value_o)
    );
  end else if (Stage == 1) begin : g_texels
    ffgpu_pkg::float_t density, texels;

    float_from_signed u_density (
      .enable_i,
      .integer_i({19'd0, operands_i.densities[13*Axis +: 13]}),
      .value_o  (density)
    );
    float_multiply u_texels (
      .enable_i,
      .a_i      (value),
      .b_i      (density),
      .product_o(texels)
    );
    always_comb begin
      // Of either sign: it is squared next.
      value_o = texels;
      if (texels[30:0] < LeastStep[30:0]) begin
        value_o[30:0] = LeastStep[30:0];
      end
      if (texels[30:0] > LargestStep[30:0]) begin
        value_o[30:0] = LargestStep[30:0];
      end
    end
  end else if (Stage == 2) begin : g_square
    float_multiply u_square (
      .enable_i,
      .a_i      (value),
      .b_i      (value),
      .product_o(value_o)
    );
  end else if (Axis == 0) begin : g_sum
    ffgpu_pkg::float_t sum;

    float_add u_sum (
      .enable_i,
      .a_i  (value),
      .b_i  (steps.values[32*Other +: 32]),
      .sum_o(sum)
    );
    assign value_o = operands_i.is_used[Stage == 3 ? 0 : 1] ? sum : value;
  end else begin : g_keep
    logic unused_enable;

    assign unused_enable = enable_i;
    assign value_o       = value;
  end

endmodule
