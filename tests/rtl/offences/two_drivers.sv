// A net with two drivers.
// Refused by: verilator yosys
module two_drivers (
  input  logic a_i,
  input  logic b_i,
  output logic value_o
);
  assign value_o = a_i;
  assign value_o = b_i;
endmodule
