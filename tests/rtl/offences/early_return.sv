// A return out of a loop.
// Refused by: yosys
module early_return (
  input  logic [7:0] value_i,
  output logic [2:0] first_o
);
  function automatic logic [2:0] first_set(input logic [7:0] value);
    for (int i = 0; i < 8; i++) begin
      if (value[i]) return i[2:0];
    end
    return 3'd0;
  endfunction
  assign first_o = first_set(value_i);
endmodule
