// A packed array of more than one dimension that is no member of a struct.
// Refused by: yosys
module array_of_vectors (
  input  logic [3:0][7:0] values_i,
  output logic [7:0]      value_o
);
  logic [3:0][7:0] copies;
  assign copies  = values_i;
  assign value_o = copies[0];
endmodule
