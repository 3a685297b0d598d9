// The pixel that is stored for a colour, in a plain colour format. Bits above the pixel's are 0.
//
// Combinational. Equals ffgpu::pack_pixel() in model/memory/color_pixel.h, with either rounding.

module pixel_pack (
  input  logic              narrow_i,  // low: nobody looks at a pixel of 16 bits
  input  logic [4:0]        format_i,
  input  ffgpu_pkg::color_t color_i,
  input  logic              dithers_i,
  input  logic [3:0]        bayer_i,
  output ffgpu_pkg::pixel_t pixel_o
);

  logic [7:0]  red, alpha;
  logic [15:0] four;
  logic [14:0] five;
  logic [5:0]  six;

  assign red   = color_i[7:0];
  assign alpha = color_i[31:24];

  // Channel 0, red, stands highest in a pixel.
  for (genvar channel = 0; channel < 4; channel++) begin : g_four
    pixel_level #(
      .Width(4)
    ) u_level (
      .enable_i (narrow_i),
      .value_i  (color_i[8*channel +: 8]),
      .dithers_i(dithers_i),
      .bayer_i  (bayer_i),
      .level_o  (four[4*(3-channel) +: 4])
    );
  end
  for (genvar channel = 0; channel < 3; channel++) begin : g_five
    pixel_level #(
      .Width(5)
    ) u_level (
      .enable_i (narrow_i),
      .value_i  (color_i[8*channel +: 8]),
      .dithers_i(dithers_i),
      .bayer_i  (bayer_i),
      .level_o  (five[5*(2-channel) +: 5])
    );
  end
  pixel_level #(
    .Width(6)
  ) u_green (
    .enable_i (narrow_i),
    .value_i  (color_i[15:8]),
    .dithers_i(dithers_i),
    .bayer_i  (bayer_i),
    .level_o  (six)
  );

  always_comb begin
    unique case (format_i)
      ffgpu_registers_pkg::FormatRgbx8: pixel_o = {8'd255, color_i[23:0]};
      ffgpu_registers_pkg::FormatLuminance8,
      ffgpu_registers_pkg::FormatIntensity8: pixel_o = {24'd0, red};
      ffgpu_registers_pkg::FormatAlpha8: pixel_o = {24'd0, alpha};
      ffgpu_registers_pkg::FormatLuminanceAlpha8: pixel_o = {16'd0, alpha, red};
      ffgpu_registers_pkg::FormatRgb565: pixel_o = {16'd0, five[14:10], six, five[4:0]};
      ffgpu_registers_pkg::FormatRgba4: pixel_o = {16'd0, four};
      ffgpu_registers_pkg::FormatRgb5a1: pixel_o = {16'd0, five, alpha[7]};
      default: pixel_o = color_i;
    endcase
  end

endmodule
