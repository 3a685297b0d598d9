// The colour of a texel of an S3TC block: one of two end points, or a step between them, by a code
// of two bits.
//
// Combinational. Equals decode_color() in model/texture/s3tc.cpp. Quotients are rounded down, by
// multiplications that are exact for all sums of three channels.

module s3tc_color (
  input  logic              enable_i,  // low: nobody looks at the colour, which is 0
  input  logic [63:0]       block_i,  // end points, then codes
  input  logic [3:0]        texel_i,
  input  logic              four_i,   // four colours whatever the order: DXT3 and DXT5
  input  logic              clear_i,  // of an ordered block code 3 is clear, not black
  output ffgpu_pkg::color_t color_o
);

  logic [1:0]        code;
  logic              has_four;
  logic [20:0]       weighted, third;
  logic [8:0]        sum;
  ffgpu_pkg::color_t a, b, twice, once, thirds, halves;

  assign code     = block_i[{1'b1, texel_i, 1'b0} +: 2];
  assign has_four = four_i || block_i[15:0] > block_i[31:16];

  pixel_unpack u_first (
    .format_i(ffgpu_registers_pkg::FormatRgb565),
    .pixel_i ({16'd0, block_i[15:0]}),
    .color_o (a)
  );
  pixel_unpack u_second (
    .format_i(ffgpu_registers_pkg::FormatRgb565),
    .pixel_i ({16'd0, block_i[31:16]}),
    .color_o (b)
  );

  assign twice = code[0] ? b : a;
  assign once  = code[0] ? a : b;
  always_comb begin
    weighted = 21'd0;
    third    = 21'd0;
    sum      = 9'd0;
    thirds   = 32'hff00_0000;
    halves   = 32'hff00_0000;
    color_o  = 32'd0;
    if (enable_i) begin
      for (int unsigned channel = 0; channel < 3; channel++) begin
        weighted = {12'd0, twice[8*channel +: 8], 1'b0} + {13'd0, once[8*channel +: 8]};
        third    = weighted * 21'd683;
        sum      = {1'b0, a[8*channel +: 8]} + {1'b0, b[8*channel +: 8]};
        thirds[8*channel +: 8] = third[18:11];
        halves[8*channel +: 8] = sum[8:1];
      end
      unique case (code)
        2'd0:    color_o = a;
        2'd1:    color_o = b;
        2'd2:    color_o = has_four ? thirds : halves;
        default: color_o = has_four ? thirds : {clear_i ? 8'd0 : 8'd255, 24'd0};
      endcase
    end
  end

endmodule
