// A binary32 number of [0, 2^Width) as an integer, rounded down.
//
// Combinational. Width is at most 24.

module float_to_unsigned #(
  parameter int unsigned Width = 20
) (
  input  ffgpu_pkg::float_t value_i,
  output logic [Width-1:0]  integer_o
);

  logic [7:0]  shift;  // of 1.23 to the right
  logic [23:0] mantissa, shifted;

  assign mantissa  = {1'b1, value_i[22:0]};
  assign shift     = 8'd150 - value_i[30:23];
  assign shifted   = value_i[30:23] < 8'd127 ? 24'd0 : mantissa >> shift[4:0];
  assign integer_o = Width'(shifted);

endmodule
