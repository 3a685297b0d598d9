// A channel of 8 bits in 4, 5 or 6: to nearest, or up or down by the place in the window.
//
// Combinational. Equals ffgpu::quantize() and dither() in model/memory/color_pixel.h.

module pixel_level #(
  parameter int unsigned Width = 4
) (
  input  logic                enable_i,  // low: nobody looks at the level
  input  ffgpu_pkg::channel_t value_i,
  input  logic                dithers_i,
  input  logic [3:0]          bayer_i,
  output logic [Width-1:0]    level_o
);

  localparam int unsigned Dropped = 8 - Width;
  localparam logic [15:0] Maximum = (16'd1 << Width) - 16'd1;

  logic [15:0]         scaled;
  ffgpu_pkg::channel_t nearest, lowered, moved;

  always_comb begin
    scaled  = 16'd0;
    lowered = 8'd0;
    moved   = 8'd0;
    nearest = 8'd0;
    level_o = '0;
    if (enable_i) begin
      scaled  = {8'd0, value_i} * Maximum + 16'd127;
      lowered = value_i - (value_i >> Width);
      moved   = lowered + {4'd0, bayer_i >> (4 - Dropped)};
      nearest = ffgpu_pkg::floor_255(scaled);
      level_o = dithers_i ? moved[7:Dropped] : nearest[Width-1:0];
    end
  end

endmodule
