// An import where yosys 0.23 reads none.
// Refused by: yosys
module import_in_header import ffgpu_pkg::*; (
  input  channel_t value_i,
  output channel_t value_o
);
  assign value_o = value_i;
endmodule
