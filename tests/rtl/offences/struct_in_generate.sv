// A net of a struct type inside a generate block: yosys does not find its members.
// Refused by: yosys
module struct_in_generate (
  input  ffgpu_pkg::texel_t texel_i,
  output logic [31:0]       color_o
);
  for (genvar i = 0; i < 2; i++) begin : g_half
    ffgpu_pkg::texel_t inner;
    assign inner = texel_i;
    for (genvar j = 0; j < 2; j++) begin : g_byte
      assign color_o[16*i+8*j +: 8] = inner.color[16*i+8*j +: 8];
    end
  end
endmodule
