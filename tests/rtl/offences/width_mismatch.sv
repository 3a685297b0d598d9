// An assignment that drops bits without saying so.
// Refused by: verilator
module width_mismatch (
  input  logic [7:0] value_i,
  output logic [3:0] value_o
);
  assign value_o = value_i;
endmodule
