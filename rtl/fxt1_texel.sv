// A texel of an FXT1 block: of 8x4 texels in 128 bits, in one of four codings.
//
// Combinational. Equals Fxt1Block::texel() in model/arith/fxt1.h. All codings are reduced to one
// step between two colours: ((n - i) a + i b) / n to nearest, n being 1, 2, 3 or 6.

module fxt1_texel (
  input  logic              enable_i,  // low: nobody looks at the colour, which is 0
  input  logic [127:0]      block_i,
  input  logic [2:0]        x_i,
  input  logic [1:0]        y_i,
  output ffgpu_pkg::color_t color_o
);

  logic [4:0]        texel;
  logic              tile, is_high, is_chroma, is_alpha, is_clear, second_green, first_green;
  logic              green_bits;
  logic [1:0]        code;
  logic [2:0]        high_code, step, steps;
  logic [6:0]        high_at;
  logic [14:0]       first_bits, second_bits, chroma_bits;
  logic [4:0]        first_alpha, second_alpha;
  logic [25:0]       sum, third, sixth;
  ffgpu_pkg::color_t first, second, mixed;

  assign tile      = x_i[2];
  assign texel     = {tile, y_i, x_i[1:0]};
  assign is_high   = block_i[127:126] == 2'd0;
  assign is_chroma = block_i[127:125] == 3'd2;
  assign is_alpha  = block_i[127:125] == 3'd3;

  assign code      = block_i[{1'b0, texel, 1'b0} +: 2];
  assign high_at   = {2'd0, texel} + {1'b0, texel, 1'b0};
  assign high_code = block_i[high_at +: 3];

  // Colours of 15 bits, blue lowest; four from bit 64 on.
  assign chroma_bits = code[1] ? (code[0] ? block_i[123:109] : block_i[108:94]) :
    (code[0] ? block_i[93:79] : block_i[78:64]);

  // A sixth bit of green: of a tile's second colour as it stands, of the first one changed by the
  // upper bit of the code of the tile's first texel.
  assign second_green = tile ? block_i[126] : block_i[125];
  assign first_green  = second_green ^ (tile ? block_i[33] : block_i[1]);

  always_comb begin
    step         = {1'b0, code};
    steps        = 3'd3;
    is_clear     = 1'b0;
    green_bits   = 1'b0;
    first_bits   = chroma_bits;
    second_bits  = chroma_bits;
    first_alpha  = 5'd31;
    second_alpha = 5'd31;
    if (!enable_i) begin
      steps = 3'd1;
    end else if (is_high) begin
      step        = high_code;
      steps       = 3'd6;
      is_clear    = high_code == 3'd7;
      first_bits  = block_i[110:96];
      second_bits = block_i[125:111];
    end else if (is_chroma) begin
      steps = 3'd1;
      step  = 3'd0;
    end else if (is_alpha && block_i[124]) begin
      first_bits   = tile ? block_i[108:94] : block_i[78:64];
      first_alpha  = tile ? block_i[123:119] : block_i[113:109];
      second_bits  = block_i[93:79];
      second_alpha = block_i[118:114];
    end else if (is_alpha) begin
      steps       = 3'd1;
      step        = 3'd0;
      is_clear    = code == 2'd3;
      first_alpha = code == 2'd0 ? block_i[113:109] : code == 2'd1 ? block_i[118:114] :
        block_i[123:119];
    end else begin
      green_bits  = 1'b1;
      first_bits  = tile ? block_i[108:94] : block_i[78:64];
      second_bits = tile ? block_i[123:109] : block_i[93:79];
      if (block_i[124]) begin
        steps    = 3'd2;
        is_clear = code == 2'd3;
      end
    end
  end

  // Of a clear code's coding the first colour has no sixth bit.
  assign first = {first_alpha, first_alpha[4:2], first_bits[4:0], first_bits[4:2],
    green_bits && !block_i[124] ? {first_bits[9:5], first_green, first_bits[9:8]} :
      {first_bits[9:5], first_bits[9:7]},
    first_bits[14:10], first_bits[14:12]};
  assign second = {second_alpha, second_alpha[4:2], second_bits[4:0], second_bits[4:2],
    green_bits ? {second_bits[9:5], second_green, second_bits[9:8]} :
      {second_bits[9:5], second_bits[9:7]},
    second_bits[14:10], second_bits[14:12]};

  always_comb begin
    sum   = 26'd0;
    third = 26'd0;
    sixth = 26'd0;
    mixed = 32'd0;
    if (enable_i && !is_clear) begin
      for (int unsigned channel = 0; channel < 4; channel++) begin
        sum = {23'd0, steps - step} * {18'd0, first[8*channel +: 8]} +
          {23'd0, step} * {18'd0, second[8*channel +: 8]} + {24'd0, steps[2:1]};
        third = sum * 26'd683;
        sixth = sum * 26'd10923;
        unique case (steps)
          3'd1:    mixed[8*channel +: 8] = sum[7:0];
          3'd2:    mixed[8*channel +: 8] = sum[8:1];
          3'd3:    mixed[8*channel +: 8] = third[18:11];
          default: mixed[8*channel +: 8] = sixth[23:16];
        endcase
      end
    end
  end

  assign color_o = mixed;

endmodule
