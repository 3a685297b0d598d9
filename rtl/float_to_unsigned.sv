// A binary32 number of [0, 2^Width) as an integer, rounded down.
//
// Combinational. Width is 2 to 24.

module float_to_unsigned #(
  parameter int unsigned Width = 20
) (
  input  ffgpu_pkg::float_t value_i,
  output logic [Width-1:0]  integer_o
);

  localparam logic [7:0] MostExponent = 8'(126 + Width);

  logic [7:0]       shift;  // of the mantissa to the right
  logic [Width-1:0] mantissa;  // its bits from 1 on, of the largest numbers

  assign mantissa  = {1'b1, value_i[22:24-Width]};
  assign shift     = MostExponent - value_i[30:23];
  assign integer_o = value_i[30:23] < 8'd127 ? Width'(0) : mantissa >> shift[4:0];

endmodule
