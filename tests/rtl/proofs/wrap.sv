// The texels of an axis. In a repeated image both are texels of it, beside each other or the last
// and the first; elsewhere none lies outside the stored image, but for the border's colour.
// Refused with: texel_pair: resolved = wraps ? 16'd0 : last -> resolved = wraps ? 16'd1 : last
// Refused with: texel_pair: place >= {3'd0, size} -> place > {3'd0, size}
// Refused with: texel_pair: coordinate_i - 24'd128 -> coordinate_i - 24'd127

module wrap_proof (
  input logic        linear_i,
  input logic        wraps_i,
  input logic        border_i,
  input logic        stored_border_i,
  input logic [12:0] size_i,
  input logic [23:0] coordinate_i
);

  logic [13:0]        first, second, end_of_stored, first_texel, second_texel;
  logic [7:0]         weight;
  logic               first_is_border, second_is_border;
  logic signed [23:0] coordinate, centre;
  logic               is_inside;

  texel_pair u_pair (
    .enable_i    (1'b1),
    .is_used_i   (1'b1),
    .linear_i,
    .wraps_i,
    .border_i,
    .stored_border_i,
    .size_i,
    .coordinate_i,
    .first_o     (first),
    .second_o    (second),
    .weight_o    (weight)
  );

  // Repeated coordinates are 0 .. size; others may be a texel outside.
  assign coordinate = coordinate_i;
  assign is_inside  = coordinate >= 24'sd0 &&
    coordinate_i <= {3'd0, size_i, 8'd0};

  assign first_is_border  = first == 14'h2000;
  assign second_is_border = second == 14'h2000;
  assign end_of_stored    = {1'b0, size_i} + {12'd0, stored_border_i, 1'b0};
  assign first_texel      = first - {13'd0, stored_border_i};
  assign second_texel     = second - {13'd0, stored_border_i};
  // Of a texel n the centre is at n + 1/2; what is at or behind it, and before the next, is n's.
  assign centre           = $signed({2'd0, first_texel, 8'd128});

  always_comb begin
    assume (size_i >= 13'd1 && size_i <= 13'd4096);
    assert (first_is_border || first < end_of_stored);
    assert (second_is_border || second < end_of_stored);
    assert (linear_i || (first == second && weight == 8'd0));
    if (wraps_i && is_inside) begin
      assert (linear_i || first_texel == 14'(coordinate_i[21:8]) ||
              coordinate_i == {3'd0, size_i, 8'd0});
      if (linear_i && !border_i) begin
        assert (first_texel < {1'b0, size_i} && second_texel < {1'b0, size_i});
        assert (second_texel == first_texel + 14'd1 ||
                (second_texel == 14'd0 && first_texel == {1'b0, size_i} - 14'd1));
        // The weight is the way from the centre of the first, or of the one before the image.
        assert (coordinate == centre + $signed({16'd0, weight}) ||
                (coordinate < 24'sd128 && coordinate == -24'sd128 + $signed({16'd0, weight})));
      end
    end
  end

endmodule
