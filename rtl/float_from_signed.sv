// A signed integer as a binary32 number, rounded to nearest even.
//
// Combinational.

module float_from_signed (
  input  logic              enable_i,  // low: nobody looks at the number, which is 0
  input  logic [31:0]       integer_i,
  output ffgpu_pkg::float_t value_o
);

  logic [31:0] magnitude, normal;
  logic [4:0]  leading;
  logic        rounds_up;
  logic [24:0] rounded;
  logic [7:0]  exponent;

  always_comb begin
    magnitude = 32'd0;
    normal    = 32'd0;
    leading   = 5'd0;
    rounds_up = 1'd0;
    rounded   = 25'd0;
    exponent  = 8'd0;
    value_o   = 32'd0;
    if (enable_i) begin
      magnitude = integer_i[31] ? ~integer_i + 32'd1 : integer_i;

      // Zeros above the leading bit, and the magnitude without them.
      normal  = magnitude;
      leading = 5'd0;
      if (normal[31:16] == 16'd0) begin
        normal     = {normal[15:0], 16'd0};
        leading[4] = 1'b1;
      end
      if (normal[31:24] == 8'd0) begin
        normal     = {normal[23:0], 8'd0};
        leading[3] = 1'b1;
      end
      if (normal[31:28] == 4'd0) begin
        normal     = {normal[27:0], 4'd0};
        leading[2] = 1'b1;
      end
      if (normal[31:30] == 2'd0) begin
        normal     = {normal[29:0], 2'd0};
        leading[1] = 1'b1;
      end
      if (!normal[31]) begin
        normal     = {normal[30:0], 1'b0};
        leading[0] = 1'b1;
      end

      rounds_up = normal[7] && (normal[6:0] != 7'd0 || normal[8]);
      rounded   = {1'b0, normal[31:8]} + {24'd0, rounds_up};
      exponent  = 8'd158 - {3'd0, leading} + {7'd0, rounded[24]};
      value_o   = magnitude == 32'd0 ? 32'd0 : {integer_i[31], exponent, rounded[22:0]};
    end
  end

endmodule
