// A binary32 number below 2^22 in magnitude as a signed integer, to the nearest, ties to even.
//
// Combinational. Equals ffgpu::round_to_int() in model/texture/wrap.h in that range.

module float_to_signed (
  input  ffgpu_pkg::float_t value_i,
  output logic [23:0]       integer_o
);

  logic [7:0]  shift;  // of the mantissa to the right
  logic [49:0] mantissa, kept;  // 26 fraction bits
  logic        rounds_up;
  logic [23:0] magnitude;

  assign shift     = 8'd150 - value_i[30:23];
  assign mantissa  = {1'b1, value_i[22:0], 26'd0};
  assign kept      = value_i[30:23] == 8'd0 || shift > 8'd25 ? 50'd0 : mantissa >> shift[4:0];
  assign rounds_up = kept[25] && (kept[24:0] != 25'd0 || kept[26]);
  assign magnitude = kept[49:26] + {23'd0, rounds_up};
  assign integer_o = value_i[31] ? -magnitude : magnitude;

endmodule
