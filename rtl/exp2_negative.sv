// round(255 2^-x), x in U4.16 and below 12, from a table of 64 chords an octave.
//
// Combinational. Equals ffgpu::exp2_negative_unorm8() in model/arith/exp2.h.

module exp2_negative (
  input  logic [19:0]         x_i,
  output ffgpu_pkg::channel_t result_o
);

  logic [17:0] base, mantissa;
  logic [11:0] slope, drop;
  logic [21:0] product;
  logic [25:0] scaled;
  logic [27:0] half, shifted;
  logic [4:0]  shift;

  exp2_table u_table (
    .chord_i(x_i[15:10]),
    .base_o (base),
    .slope_o(slope)
  );

  assign product  = {10'd0, slope} * {12'd0, x_i[9:0]} + 22'd512;
  assign drop     = product[21:10];
  assign mantissa = base - {6'd0, drop};
  assign scaled   = {mantissa, 8'd0} - {8'd0, mantissa};
  assign shift    = 5'd17 + {1'b0, x_i[19:16]};
  assign half     = 28'd1 << (shift - 5'd1);
  assign shifted  = ({2'd0, scaled} + half) >> shift;
  assign result_o = shifted[7:0];

endmodule
