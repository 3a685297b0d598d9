// The lerp of the filters, of a colour: (a (256 - weight) + b weight) / 256 to nearest, halves up.
//
// Combinational. Equals ffgpu::lerp8w() in model/texture/filter.h.

module texture_lerp (
  input  logic               enable_i,  // low: nobody looks at the value, which is 0
  input  ffgpu_pkg::color_t  a_i,
  input  ffgpu_pkg::color_t  b_i,
  input  ffgpu_pkg::weight_t weight_i,
  output ffgpu_pkg::color_t  value_o
);

  always_comb begin
    value_o = 32'd0;
    if (enable_i) begin
      for (int unsigned channel = 0; channel < 4; channel++) begin
        value_o[8*channel +: 8] =
          ffgpu_pkg::lerp8w(a_i[8*channel +: 8], b_i[8*channel +: 8], weight_i);
      end
    end
  end

endmodule
