// One step of one lane through the division by w or q: an integer to binary32, times the reciprocal,
// times the attribute's power of two, and for colours to 0 .. 255.
//
// Combinational; Stage says which step it is.

module perspective_lane #(
  parameter int unsigned Stage = 0,
  parameter int unsigned Lane = 0
) (
  input  logic                         enable_i,  // low: nobody looks at the value
  input  ffgpu_pkg::perspective_quad_t quad_i,
  output logic [31:0]                  value_o
);

  localparam logic [31:0] Half = 32'h3f00_0000;
  localparam logic [31:0] LargestColor = 32'h437f_0000;  // 255
  localparam logic [30:0] LeastFog = 31'h3080_0000;  // 2^-30
  localparam logic [30:0] LargestFog = 31'h4e80_0000;  // 2^30

  logic [31:0] value;
  assign value = quad_i.values[32*Lane +: 32];

  if (Stage == 0) begin : g_convert
    logic [31:0] whole;

    // Signed numbers compare as unsigned ones when their signs are turned.
    always_comb begin
      whole = value;
      if (quad_i.kind == ffgpu_pkg::PerspectiveInverseW &&
          {~value[31], value[30:0]} < {~quad_i.floor[31], quad_i.floor[30:0]}) begin
        whole = quad_i.floor;
      end
      if (quad_i.kind == ffgpu_pkg::PerspectiveQ && value == 32'd0) begin
        whole = 32'd1;
      end
    end
    float_from_signed u_convert (
      .enable_i,
      .integer_i(whole),
      .value_o
    );
  end else if (Stage == 1) begin : g_divide
    float_multiply u_multiply (
      .enable_i,
      .a_i      (value),
      .b_i      (quad_i.factors[32*Lane +: 32]),
      .product_o(value_o)
    );
  end else if (Stage == 2) begin : g_scale
    logic [7:0]  exponent;
    logic [31:0] scaled, clamped;

    always_comb begin
      exponent = 8'd0;
      scaled   = value;
      if (enable_i && value[30:23] != 8'd0) begin
        exponent = value[30:23] + quad_i.scale - 8'd127;
        scaled   = {value[31], exponent, value[22:0]};
      end
    end
    float_clamp #(
      .Most(LargestColor)
    ) u_clamp (
      .value_i  (scaled),
      .clamped_o(clamped)
    );
    always_comb begin
      value_o = scaled;
      if (quad_i.kind == ffgpu_pkg::PerspectiveColor) begin
        value_o = clamped;
      end
      if (quad_i.kind == ffgpu_pkg::PerspectiveFog && scaled[30:0] < LeastFog) begin
        value_o = 32'd0;
      end
      if (quad_i.kind == ffgpu_pkg::PerspectiveFog && scaled[30:0] > LargestFog) begin
        value_o = {scaled[31], LargestFog};
      end
    end
  end else begin : g_round
    logic [31:0] biased;
    logic [7:0]  color;

    float_add u_bias (
      .enable_i,
      .a_i  (value),
      .b_i  (Half),
      .sum_o(biased)
    );
    float_to_unsigned #(
      .Width(8)
    ) u_color (
      .value_i  (biased),
      .integer_o(color)
    );
    assign value_o = quad_i.kind == ffgpu_pkg::PerspectiveColor ? {24'd0, color} : value;
  end

endmodule
