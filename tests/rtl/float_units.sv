// The units of binary32 side by side, for their test.

module float_units (
  input  logic              enable_i,
  input  ffgpu_pkg::float_t a_i,
  input  ffgpu_pkg::float_t b_i,
  output ffgpu_pkg::float_t product_o,
  output ffgpu_pkg::float_t sum_o,
  output logic [19:0]       integer_o,
  output logic [23:0]       nearest_o,
  input  logic [31:0]       signed_i,
  output ffgpu_pkg::float_t converted_o,
  output ffgpu_pkg::float_t clamped_o,  // to 1
  output ffgpu_pkg::float_t clamped_wide_o  // to 3
);

  float_multiply u_multiply (
    .enable_i,
    .a_i,
    .b_i,
    .product_o
  );
  float_add u_add (
    .enable_i,
    .a_i,
    .b_i,
    .sum_o
  );
  float_to_unsigned #(
    .Width(20)
  ) u_to_unsigned (
    .value_i(a_i),
    .integer_o
  );
  float_to_signed u_to_signed (
    .value_i  (a_i),
    .integer_o(nearest_o)
  );
  float_from_signed u_from_signed (
    .enable_i,
    .integer_i(signed_i),
    .value_o  (converted_o)
  );
  float_clamp u_clamp (
    .value_i  (a_i),
    .clamped_o
  );
  float_clamp #(
    .Most(32'h4040_0000)
  ) u_clamp_wide (
    .value_i  (a_i),
    .clamped_o(clamped_wide_o)
  );

endmodule
