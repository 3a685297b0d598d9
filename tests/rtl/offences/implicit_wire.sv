// A net that nobody declared.
// Refused by: verilator yosys
module implicit_wire (
  input  logic value_i,
  output logic value_o
);
  assign undeclared = !value_i;
  assign value_o = undeclared;
endmodule
