// What one stage of fog does to a lane's number: from the fog coordinate to the factor, 0 .. 255.
//
//     stage    Linear                 Exp              Exp2
//     0        end - c                c k              c k
//     1        f = (end - c) k        x                (c k) (c k)
//     2        255 clamp(f)           x                x = (c k) (c k) log2 e
//     3        + 1/2                  65536 clamp(x) + 1/2
//     4        rounded down           255 2^-x by table
//
// Combinational. In binary32 up to the sum of stage 3, each operation rounded on its own. Equals
// ffgpu::fog_factor() in model/fragment/fog.cpp, together with the other stages.

module fog_lane #(
  parameter int unsigned Stage = 0
) (
  input  logic                  enable_i,  // low: nobody looks at the value
  input  ffgpu_pkg::fog_curve_t curve_i,
  input  ffgpu_pkg::float_t     value_i,
  output ffgpu_pkg::float_t     value_o
);

  localparam logic [31:0] One = 32'h3f80_0000;
  localparam logic [31:0] Half = 32'h3f00_0000;
  localparam logic [31:0] Largest = 32'h437f_0000;  // 255
  localparam logic [31:0] Log2E = 32'h3fb8_aa3b;
  localparam logic [31:0] ExponentLimit = 32'h4138_0000;  // 11.5: 255 2^-11.5 rounds to 0

  logic              is_linear, passes;  // Exp in the stages of the square's products
  ffgpu_pkg::float_t result;

  assign is_linear = curve_i.mode == ffgpu_registers_pkg::FogModeLinear;
  assign passes    = (Stage == 1 || Stage == 2) &&
    curve_i.mode != ffgpu_registers_pkg::FogModeLinear &&
    curve_i.mode != ffgpu_registers_pkg::FogModeExp2;
  assign value_o   = passes ? value_i : result;

  if (Stage == 0) begin : g_coordinate
    ffgpu_pkg::float_t difference, product;

    float_add u_difference (
      .enable_i,
      .a_i  (curve_i.end_coordinate),
      .b_i  ({!value_i[31], value_i[30:0]}),
      .sum_o(difference)
    );
    float_multiply u_product (
      .enable_i,
      .a_i      (value_i),
      .b_i      (curve_i.scale),
      .product_o(product)
    );
    assign result = is_linear ? difference : product;
  end else if (Stage == 1) begin : g_curve
    ffgpu_pkg::float_t product;

    float_multiply u_product (
      .enable_i,
      .a_i      (value_i),
      .b_i      (is_linear ? curve_i.scale : value_i),
      .product_o(product)
    );
    assign result = product;
  end else if (Stage == 2) begin : g_scale
    ffgpu_pkg::float_t clamped, product;

    float_clamp #(
      .Most(One)
    ) u_clamp (
      .value_i  (value_i),
      .clamped_o(clamped)
    );
    float_multiply u_product (
      .enable_i,
      .a_i      (is_linear ? clamped : value_i),
      .b_i      (is_linear ? Largest : Log2E),
      .product_o(product)
    );
    assign result = product;
  end else if (Stage == 3) begin : g_round
    ffgpu_pkg::float_t clamped, fixed;

    float_clamp #(
      .Most(ExponentLimit)
    ) u_clamp (
      .value_i  (value_i),
      .clamped_o(clamped)
    );
    // Times 2^16; 0 becomes 2^-111, which adds nothing to a half.
    assign fixed = {1'b0, clamped[30:23] + 8'd16, clamped[22:0]};
    float_add u_sum (
      .enable_i,
      .a_i  (is_linear ? value_i : fixed),
      .b_i  (Half),
      .sum_o(result)
    );
  end else begin : g_factor
    logic [19:0] fixed;
    logic [7:0]  exponential;

    float_to_unsigned #(
      .Width(20)
    ) u_fixed (
      .value_i  (value_i),
      .integer_o(fixed)
    );
    exp2_negative u_exponential (
      .x_i     (fixed),
      .result_o(exponential)
    );
    always_comb begin
      result = 32'd0;
      if (enable_i) begin
        result[7:0] = is_linear ? fixed[7:0] : exponential;
      end
    end
  end

endmodule
