// The pixel of a colour target afterwards: the blended colour in the target's precision, combined
// by the logic operation with what is stored, under the write mask.
//
// Combinational. Equals what follows the blend in ffgpu::written_color(), model/fragment/
// color_target.cpp, on stored words: a level read and stored again stays, so that operation and
// mask may work on the levels themselves.

module color_write (
  input  logic                        enable_i,  // low: nobody looks at the pixel
  input  ffgpu_registers_pkg::blend_t state_i,
  input  logic [4:0]                  format_i,
  input  logic                        dither_i,
  input  ffgpu_pkg::color_t           color_i,
  input  ffgpu_pkg::pixel_t           stored_i,
  input  logic [1:0]                  x_i,
  input  logic [1:0]                  y_i,

  output ffgpu_pkg::pixel_t           pixel_o,
  output logic [3:0]                  enables_o  // of bytes
);

  // Bayer's matrix, threshold (y, x) at 4 (4 y + x).
  localparam logic [63:0] Bayer = 64'h5d7f_91b3_6e4c_a280;

  logic              is_narrow, is_wide, is_plain;
  logic [3:0]        bayer, stored_channels, mask;
  ffgpu_pkg::pixel_t source, combined, bits;

  assign bayer     = Bayer[{y_i, x_i, 2'b00} +: 4];
  assign is_narrow = format_i == ffgpu_registers_pkg::FormatRgb565 ||
    format_i == ffgpu_registers_pkg::FormatRgba4 || format_i == ffgpu_registers_pkg::FormatRgb5a1;
  assign is_wide = format_i == ffgpu_registers_pkg::FormatRgba8 ||
    format_i == ffgpu_registers_pkg::FormatRgbx8;
  assign is_plain = format_i >= ffgpu_registers_pkg::FormatRgba8 &&
    format_i <= ffgpu_registers_pkg::FormatRgb5a1;

  pixel_pack u_pack (
    .narrow_i (enable_i && is_narrow),
    .format_i (format_i),
    .color_i  (color_i),
    .dithers_i(dither_i && is_narrow),
    .bayer_i  (bayer),
    .pixel_o  (source)
  );

  always_comb begin
    combined = source;
    if (enable_i && state_i.logic_op_enable) begin
      unique case (state_i.logic_op)
        ffgpu_registers_pkg::LogicOpClear:        combined = 32'd0;
        ffgpu_registers_pkg::LogicOpAnd:          combined = source & stored_i;
        ffgpu_registers_pkg::LogicOpAndReverse:   combined = source & ~stored_i;
        ffgpu_registers_pkg::LogicOpCopy:         combined = source;
        ffgpu_registers_pkg::LogicOpAndInverted:  combined = ~source & stored_i;
        ffgpu_registers_pkg::LogicOpNoop:         combined = stored_i;
        ffgpu_registers_pkg::LogicOpXor:          combined = source ^ stored_i;
        ffgpu_registers_pkg::LogicOpOr:           combined = source | stored_i;
        ffgpu_registers_pkg::LogicOpNor:          combined = ~(source | stored_i);
        ffgpu_registers_pkg::LogicOpEquiv:        combined = ~(source ^ stored_i);
        ffgpu_registers_pkg::LogicOpInvert:       combined = ~stored_i;
        ffgpu_registers_pkg::LogicOpOrReverse:    combined = source | ~stored_i;
        ffgpu_registers_pkg::LogicOpCopyInverted: combined = ~source;
        ffgpu_registers_pkg::LogicOpOrInverted:   combined = ~source | stored_i;
        ffgpu_registers_pkg::LogicOpNand:         combined = ~(source & stored_i);
        ffgpu_registers_pkg::LogicOpSet:          combined = 32'hffff_ffff;
      endcase
    end
  end

  always_comb begin
    unique case (format_i)
      ffgpu_registers_pkg::FormatRgbx8,
      ffgpu_registers_pkg::FormatRgb565:          stored_channels = 4'b0111;
      ffgpu_registers_pkg::FormatLuminance8,
      ffgpu_registers_pkg::FormatIntensity8:      stored_channels = 4'b0001;
      ffgpu_registers_pkg::FormatAlpha8:          stored_channels = 4'b1000;
      ffgpu_registers_pkg::FormatLuminanceAlpha8: stored_channels = 4'b1001;
      default:                                    stored_channels = 4'b1111;
    endcase
  end
  assign mask = is_plain ? state_i.write_mask & stored_channels : 4'd0;

  // The pixel's bits of the channels in the mask.
  always_comb begin
    unique case (format_i)
      ffgpu_registers_pkg::FormatRgbx8: bits = {8'd0, {8{mask[2]}}, {8{mask[1]}}, {8{mask[0]}}};
      ffgpu_registers_pkg::FormatLuminance8,
      ffgpu_registers_pkg::FormatIntensity8:      bits = {24'd0, {8{mask[0]}}};
      ffgpu_registers_pkg::FormatAlpha8:          bits = {24'd0, {8{mask[3]}}};
      ffgpu_registers_pkg::FormatLuminanceAlpha8: bits = {16'd0, {8{mask[3]}}, {8{mask[0]}}};
      ffgpu_registers_pkg::FormatRgb565:
        bits = {16'd0, {5{mask[0]}}, {6{mask[1]}}, {5{mask[2]}}};
      ffgpu_registers_pkg::FormatRgba4:
        bits = {16'd0, {4{mask[0]}}, {4{mask[1]}}, {4{mask[2]}}, {4{mask[3]}}};
      ffgpu_registers_pkg::FormatRgb5a1:
        bits = {16'd0, {5{mask[0]}}, {5{mask[1]}}, {5{mask[2]}}, mask[3]};
      default: bits = {{8{mask[3]}}, {8{mask[2]}}, {8{mask[1]}}, {8{mask[0]}}};
    endcase
  end

  // The spare byte of Rgbx8 is 255, whatever it was.
  always_comb begin
    pixel_o = (combined & bits) | (stored_i & ~bits);
    if (format_i == ffgpu_registers_pkg::FormatRgbx8) begin
      pixel_o[31:24] = 8'd255;
    end
    enables_o = {{2{is_wide}}, is_wide || is_narrow ||
                 format_i == ffgpu_registers_pkg::FormatLuminanceAlpha8, 1'b1};
    if (mask == 4'd0) begin
      enables_o = 4'd0;
    end
  end

endmodule
