// The alpha of a texel of a DXT3 or a DXT5 block: four bits of its own, or a step between two end
// points by a code of three bits.
//
// Combinational. Equals decode_dxt3_alpha() and decode_dxt5_alpha() in model/texture/s3tc.cpp.
// Quotients are rounded down, by multiplications that are exact for all sums.

module s3tc_alpha (
  input  logic                enable_i,  // low: nobody looks at it, and it is 0
  input  logic [63:0]         block_i,
  input  logic [3:0]          texel_i,
  input  logic                is_dxt5_i,
  output ffgpu_pkg::channel_t alpha_o
);

  logic [3:0]  nibble;
  logic [2:0]  code;
  logic [5:0]  code_at;
  logic [7:0]  a, b, steps;
  logic [26:0] first_weight, second_weight, sum, seventh, fifth;
  logic        has_eight;

  assign nibble    = block_i[{texel_i, 2'b00} +: 4];
  assign a         = block_i[7:0];
  assign b         = block_i[15:8];
  assign has_eight = a > b;
  assign code_at   = 6'd16 + {2'd0, texel_i} + {1'b0, texel_i, 1'b0};
  assign code      = block_i[code_at +: 3];

  // Codes 2 to 7 in sevenths, or 2 to 5 in fifths.
  always_comb begin
    first_weight  = 27'd0;
    second_weight = 27'd0;
    sum           = 27'd0;
    seventh       = 27'd0;
    fifth         = 27'd0;
    steps         = 8'd0;
    alpha_o       = 8'd0;
    if (enable_i) begin
      first_weight  = (has_eight ? 27'd8 : 27'd6) - {24'd0, code};
      second_weight = {24'd0, code} - 27'd1;
      sum           = first_weight * {19'd0, a} + second_weight * {19'd0, b};
      seventh       = sum * 27'd9363;
      fifth         = sum * 27'd13108;
      steps         = has_eight ? seventh[23:16] : fifth[23:16];
      if (!has_eight && code >= 3'd6) begin
        steps = code[0] ? 8'd255 : 8'd0;
      end
      if (code < 3'd2) begin
        steps = code[0] ? b : a;
      end
      alpha_o = is_dxt5_i ? steps : {2{nibble}};
    end
  end

endmodule
