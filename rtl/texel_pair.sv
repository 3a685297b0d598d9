// The one or two texels of an axis at a texel coordinate, in the stored image, and the second's
// weight.
//
// Combinational. Equals nearest_texel() and linear_texels() in model/texture/wrap.h, and
// stored_coordinate() in texel_read.cpp.

module texel_pair (
  input  logic        enable_i,   // low: nobody looks at the texels
  input  logic        is_used_i,  // The filter has the axis.
  input  logic        linear_i,
  input  logic        wraps_i,
  input  logic        border_i,   // Indices beyond the edges mean border texels.
  input  logic        stored_border_i,
  input  logic [12:0] size_i,     // of the level
  input  logic [23:0] coordinate_i,  // signed, 8 fraction bits
  output logic [13:0] first_o,
  output logic [13:0] second_o,
  output logic [7:0]  weight_o
);

  localparam logic [13:0] Border = 14'd1 << ffgpu_texture_pkg::TexelPlaceBorder;

  logic [23:0] from_centre;
  logic [15:0] first, second;

  function automatic logic [15:0] resolved(
    input logic [15:0] index,
    input logic [12:0] size,
    input logic        wraps,
    input logic        border
  );
    logic [15:0] last;
    last = {3'd0, size} - 16'd1 + {15'd0, border};
    resolved = index;
    if (index[15]) begin
      resolved = wraps ? {3'd0, size} - 16'd1 : 16'hffff;
    end else if (index > last) begin
      resolved = wraps ? 16'd0 : last;
    end
  endfunction

  // Counted from the border's texel, if there is one; beyond it the border's colour.
  function automatic logic [13:0] stored(
    input logic [15:0] index,
    input logic [12:0] size,
    input logic        stored_border
  );
    logic [15:0] place;
    place = index + {15'd0, stored_border};
    stored = place[13:0];
    if (place[15] || place >= {3'd0, size} + {14'd0, stored_border, 1'b0}) begin
      stored = Border;
    end
  endfunction

  always_comb begin
    from_centre = 24'd0;
    first       = 16'd0;
    second      = 16'd0;
    first_o     = 14'd0;
    second_o    = 14'd0;
    weight_o    = 8'd0;
    if (enable_i && is_used_i) begin
      from_centre = linear_i ? coordinate_i - 24'd128 : coordinate_i;
      first       = from_centre[23:8];
      second      = linear_i ? first + 16'd1 : first;

      first_o  = stored(resolved(first, size_i, wraps_i, border_i), size_i, stored_border_i);
      second_o = stored(resolved(second, size_i, wraps_i, border_i), size_i, stored_border_i);
      weight_o = linear_i ? from_centre[7:0] : 8'd0;
    end
  end

endmodule
