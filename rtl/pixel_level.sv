// A channel of 8 bits in 4, 5 or 6: to nearest, or up or down by the place in the window.
//
// Combinational. Equals ffgpu::quantize() and dither() in model/memory/color_pixel.h.

module pixel_level #(
  parameter int unsigned Width = 4
) (
  input  ffgpu_pkg::channel_t value_i,
  input  logic                dithers_i,
  input  logic [3:0]          bayer_i,
  output logic [Width-1:0]    level_o
);

  localparam int unsigned Dropped = 8 - Width;
  localparam logic [15:0] Maximum = (16'd1 << Width) - 16'd1;

  logic [15:0]         scaled;
  ffgpu_pkg::channel_t nearest, lowered, moved;

  assign scaled  = {8'd0, value_i} * Maximum + 16'd127;
  assign nearest = ffgpu_pkg::floor_255(scaled);
  assign lowered = value_i - (value_i >> Width);
  assign moved   = lowered + {4'd0, bayer_i >> (4 - Dropped)};
  assign level_o = dithers_i ? moved[7:Dropped] : nearest[Width-1:0];

endmodule
