// The lowest attribute of a set, and the set without it.
//
// Combinational. An empty set gives attribute 0.

module lowest_attribute (
  input  logic [ffgpu_pipe_pkg::Attributes-1:0] attributes_i,
  output logic [5:0]                            lowest_o,
  output logic [ffgpu_pipe_pkg::Attributes-1:0] others_o
);

  localparam int Last = 47;

  always_comb begin
    lowest_o = 6'd0;
    for (int i = Last; i >= 0; i--) begin
      if (attributes_i[i]) begin
        lowest_o = i[5:0];
      end
    end
  end
  assign others_o = attributes_i & (attributes_i - 48'd1);

endmodule
