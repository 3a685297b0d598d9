// A concurrent assertion in a unit: it belongs to the checker that is bound to it.
// Refused by: yosys
module assertion_in_unit (
  input  logic clk_i,
  input  logic value_i,
  output logic value_o
);
  assign value_o = value_i;
  Known_A: assert property (@(posedge clk_i) value_i |-> value_o);
endmodule
