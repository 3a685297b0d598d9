// The colour that a stored pixel of a plain colour format reads as.
//
// Combinational. Equals ffgpu::unpack_pixel() in model/memory/color_pixel.h.

module pixel_unpack (
  input  logic [4:0]        format_i,
  input  ffgpu_pkg::pixel_t pixel_i,
  output ffgpu_pkg::color_t color_o
);

  localparam logic [7:0] Opaque = 8'd255;

  logic [7:0] low, high;

  assign low  = pixel_i[7:0];
  assign high = pixel_i[15:8];

  // Fewer than eight bits: the upper ones are repeated below.
  always_comb begin
    unique case (format_i)
      ffgpu_registers_pkg::FormatRgbx8:           color_o = {Opaque, pixel_i[23:0]};
      ffgpu_registers_pkg::FormatLuminance8:      color_o = {Opaque, low, low, low};
      ffgpu_registers_pkg::FormatAlpha8:          color_o = {low, 24'd0};
      ffgpu_registers_pkg::FormatIntensity8:      color_o = {low, low, low, low};
      ffgpu_registers_pkg::FormatLuminanceAlpha8: color_o = {high, low, low, low};
      ffgpu_registers_pkg::FormatRgb565:
        color_o = {Opaque, pixel_i[4:0], pixel_i[4:2], pixel_i[10:5], pixel_i[10:9],
                   pixel_i[15:11], pixel_i[15:13]};
      ffgpu_registers_pkg::FormatRgba4:
        color_o = {{2{pixel_i[3:0]}}, {2{pixel_i[7:4]}}, {2{pixel_i[11:8]}}, {2{pixel_i[15:12]}}};
      ffgpu_registers_pkg::FormatRgb5a1:
        color_o = {{8{pixel_i[0]}}, pixel_i[5:1], pixel_i[5:3], pixel_i[10:6], pixel_i[10:8],
                   pixel_i[15:11], pixel_i[15:13]};
      default: color_o = pixel_i;
    endcase
  end

endmodule
