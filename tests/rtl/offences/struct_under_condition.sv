// A function that gives a struct, called in one branch alone: yosys keeps its result as a latch.
// Refused by: yosys
module struct_under_condition (
  input  logic                              enable_i,
  input  ffgpu_registers_pkg::blend_words_t words_i,
  output logic                              enable_o
);
  ffgpu_registers_pkg::blend_t blend;

  always_comb begin
    blend = '0;
    if (enable_i) begin
      blend = ffgpu_registers_pkg::decode_blend(words_i);
    end
  end
  assign enable_o = blend.enable;
endmodule
