// The lowest attribute of a set, and the set without it.
//
// Combinational. An empty set gives attribute 0.

module lowest_attribute (
  input  logic [ffgpu_pipe_pkg::Attributes-1:0] attributes_i,
  output logic [5:0]                            lowest_o,
  output logic [ffgpu_pipe_pkg::Attributes-1:0] others_o
);

  logic [ffgpu_pipe_pkg::Attributes-1:0] lowest;  // alone

  assign others_o = attributes_i & (attributes_i - 48'd1);
  assign lowest   = attributes_i & ~others_o;

  // Bit n of its number is that of all places in which it is set.
  assign lowest_o = {|(lowest & 48'hffff_0000_0000), |(lowest & 48'h0000_ffff_0000),
                     |(lowest & 48'hff00_ff00_ff00), |(lowest & 48'hf0f0_f0f0_f0f0),
                     |(lowest & 48'hcccc_cccc_cccc), |(lowest & 48'haaaa_aaaa_aaaa)};

endmodule
