// A value that is kept where no branch gives one.
// Refused by: verilator yosys
module latch (
  input  logic enable_i,
  input  logic value_i,
  output logic value_o
);
  always_comb begin
    if (enable_i) begin
      value_o = value_i;
    end
  end
endmodule
