// Texel decode: from bytes of a texture to four 8-bit channels, or of a depth texture to what the
// comparison or the depth itself becomes.
//
// Latency 2, one texel a cycle: the format; sRGB and depth. Equals decode_color_texel(),
// decode_s3tc(), decode_fxt1(), linear_from_srgb() and depth_color() in model/texture, as
// read_texel() calls them.

module texel_decode (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  logic                    in_valid_i,
  output logic                    in_ready_o,
  input  ffgpu_pkg::texel_block_t in_data_i,

  output logic                    out_valid_o,
  input  logic                    out_ready_i,
  output ffgpu_pkg::texel_t       out_data_o
);

  // Stage 1. The block's place holds the colour, or the depth in 24 bits, from then on.
  ffgpu_pkg::texel_block_t decoded_d, decoded_q;
  logic                    decoded_valid, decoded_ready, takes, is_dxt1, is_s3tc, is_fxt1;
  logic [63:0]             color_block;
  ffgpu_pkg::color_t       plain, blocks, fxt1, value;
  ffgpu_pkg::channel_t     blocks_alpha;

  assign is_dxt1 = in_data_i.format == ffgpu_registers_pkg::FormatDxt1Rgb ||
    in_data_i.format == ffgpu_registers_pkg::FormatDxt1Rgba;
  assign is_s3tc = is_dxt1 || in_data_i.format == ffgpu_registers_pkg::FormatDxt3 ||
    in_data_i.format == ffgpu_registers_pkg::FormatDxt5;
  assign is_fxt1 = in_data_i.format == ffgpu_registers_pkg::FormatFxt1Rgb ||
    in_data_i.format == ffgpu_registers_pkg::FormatFxt1Rgba;
  assign takes       = in_valid_i && in_ready_o;
  assign color_block = is_dxt1 ? in_data_i.block[63:0] : in_data_i.block[127:64];

  pixel_unpack u_plain (
    .format_i(in_data_i.format),
    .pixel_i (in_data_i.block[31:0]),
    .color_o (plain)
  );
  s3tc_color u_s3tc_color (
    .enable_i(takes && is_s3tc),
    .block_i(color_block),
    .texel_i({in_data_i.y, in_data_i.x[1:0]}),
    .four_i (!is_dxt1),
    .clear_i(in_data_i.format == ffgpu_registers_pkg::FormatDxt1Rgba),
    .color_o(blocks)
  );
  s3tc_alpha u_s3tc_alpha (
    .enable_i (takes && is_s3tc && !is_dxt1),
    .block_i  (in_data_i.block[63:0]),
    .texel_i  ({in_data_i.y, in_data_i.x[1:0]}),
    .is_dxt5_i(in_data_i.format == ffgpu_registers_pkg::FormatDxt5),
    .alpha_o  (blocks_alpha)
  );
  fxt1_texel u_fxt1 (
    .enable_i(takes && is_fxt1),
    .block_i(in_data_i.block),
    .x_i    (in_data_i.x),
    .y_i    (in_data_i.y),
    .color_o(fxt1)
  );

  always_comb begin
    value = plain;
    unique case (in_data_i.format)
      ffgpu_registers_pkg::FormatDxt1Rgb,
      ffgpu_registers_pkg::FormatDxt1Rgba:  value = blocks;
      ffgpu_registers_pkg::FormatDxt3,
      ffgpu_registers_pkg::FormatDxt5:      value = {blocks_alpha, blocks[23:0]};
      ffgpu_registers_pkg::FormatFxt1Rgb:   value = {8'd255, fxt1[23:0]};
      ffgpu_registers_pkg::FormatFxt1Rgba:  value = fxt1;
      ffgpu_registers_pkg::FormatDepth16:
        value[23:0] = {in_data_i.block[15:0], in_data_i.block[15:8]};
      ffgpu_registers_pkg::FormatDepth24Stencil8: value[23:0] = in_data_i.block[31:8];
      default: ;
    endcase
    if (in_data_i.is_border) begin
      value = in_data_i.block[31:0];
    end
    decoded_d       = in_data_i;
    decoded_d.block = {96'd0, value};
  end

  pipeline_register #(
    .Width($bits(decoded_d))
  ) u_decoded (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i  (decoded_d),
    .out_valid_o(decoded_valid),
    .out_ready_i(decoded_ready),
    .out_data_o (decoded_q)
  );

  // Stage 2. A border's colour is what it is.
  ffgpu_pkg::texel_t   texel_d;
  ffgpu_pkg::color_t   color, linear, shown;
  ffgpu_pkg::channel_t depth;
  logic                is_depth, passes;

  assign color    = decoded_q.block[31:0];
  assign is_depth = decoded_q.format == ffgpu_registers_pkg::FormatDepth16 ||
    decoded_q.format == ffgpu_registers_pkg::FormatDepth24Stencil8;
  assign passes = ffgpu_pkg::compare(decoded_q.relation, decoded_q.depth_reference, color[23:0]);
  assign depth  = decoded_q.compare_enable ? {8{passes}} : color[23:16];

  for (genvar channel = 0; channel < 3; channel++) begin : g_linear
    srgb_table u_table (
      .code_i  (color[8*channel +: 8]),
      .linear_o(linear[8*channel +: 8])
    );
  end
  assign linear[31:24] = color[31:24];

  always_comb begin
    unique case (decoded_q.depth_mode)
      ffgpu_registers_pkg::DepthModeIntensity: shown = {4{depth}};
      ffgpu_registers_pkg::DepthModeAlpha:     shown = {depth, 24'd0};
      default:                                 shown = {8'd255, {3{depth}}};
    endcase
    texel_d.tag   = decoded_q.tag;
    texel_d.place = decoded_q.place;
    texel_d.color = decoded_q.srgb && !decoded_q.is_border ? linear : color;
    if (is_depth) begin
      texel_d.color = shown;
    end
  end

  pipeline_register #(
    .Width($bits(texel_d))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (decoded_valid),
    .in_ready_o (decoded_ready),
    .in_data_i  (texel_d),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
