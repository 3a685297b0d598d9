// A cast by a typedef: widths are changed by concatenation or by an assignment to a named net.
// Refused by: yosys
module cast_by_typedef (
  input  logic [3:0]          value_i,
  output ffgpu_pkg::channel_t value_o
);
  assign value_o = ffgpu_pkg::channel_t'({4'd0, value_i});
endmodule
