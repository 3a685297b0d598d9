// A signed integer as a binary32 number, rounded to nearest even.
//
// Combinational.

module float_from_signed (
  input  logic [31:0]       integer_i,
  output ffgpu_pkg::float_t value_o
);

  logic [31:0] magnitude, normal;
  logic [4:0]  leading;
  logic        rounds_up;
  logic [24:0] rounded;
  logic [7:0]  exponent;

  assign magnitude = integer_i[31] ? ~integer_i + 32'd1 : integer_i;

  // Zeros above the leading bit.
  always_comb begin
    leading = 5'd0;
    for (int unsigned i = 0; i < 32; i++) begin
      if (magnitude[i]) begin
        leading = 5'd31 - i[4:0];
      end
    end
  end

  assign normal    = magnitude << leading;
  assign rounds_up = normal[7] && (normal[6:0] != 7'd0 || normal[8]);
  assign rounded   = {1'b0, normal[31:8]} + {24'd0, rounds_up};
  assign exponent  = 8'd158 - {3'd0, leading} + {7'd0, rounded[24]};
  assign value_o   = magnitude == 32'd0 ? 32'd0 : {integer_i[31], exponent, rounded[22:0]};

endmodule
