// The base-2 logarithm of a positive binary32 number, with 8 fraction bits, rounded down.
//
// Combinational. Equals ffgpu::log2_fixed8_bits() in model/arith/log2.h.

module level_logarithm (
  input  ffgpu_pkg::float_t value_i,
  output logic [17:0]       logarithm_o  // signed
);

  logic [9:0] exponent;
  logic [7:0] fraction;

  log2_table u_table (
    .index_i(value_i[22:15]),
    .entry_o(fraction)
  );
  assign exponent    = {2'd0, value_i[30:23]} - 10'd127;
  assign logarithm_o = {exponent, fraction};

endmodule
