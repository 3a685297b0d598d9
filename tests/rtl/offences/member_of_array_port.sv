// A member of an array of structs in a port: yosys makes an implicit wire of it.
// Refused by: yosys
module member_of_array_port (
  input  ffgpu_pkg::texel_t texels_i [2],
  output ffgpu_pkg::color_t color_o
);
  assign color_o = texels_i[0].color ^ texels_i[1].color;
endmodule
