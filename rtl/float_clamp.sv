// A binary32 number clamped to [0, Most].
//
// Combinational. Zeros and normal numbers only; -0 becomes 0.

module float_clamp #(
  parameter logic [31:0] Most = 32'h3f80_0000
) (
  input  ffgpu_pkg::float_t value_i,
  output ffgpu_pkg::float_t clamped_o
);

  // Of positive numbers the bits compare as integers.
  always_comb begin
    clamped_o = value_i[30:0] < Most[30:0] ? value_i : Most;
    if (value_i[31]) begin
      clamped_o = 32'd0;
    end
  end

endmodule
