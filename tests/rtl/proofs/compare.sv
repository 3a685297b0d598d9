// The eight relations of alpha, stencil and depth tests, by the borrow of a difference and by its
// being 0.
// Refused with: ffgpu_pkg: value <= reference -> value < reference
// Refused with: ffgpu_pkg: value >= reference -> value[22:0] >= reference[22:0]

module compare_proof (
  input logic [23:0] value_i,
  input logic [23:0] reference_i
);

  logic [24:0] difference;
  logic [7:0]  holds;
  logic        less, equal;

  assign difference = {1'b0, value_i} - {1'b0, reference_i};
  assign less       = difference[24];
  assign equal      = difference == 25'd0;

  for (genvar relation = 0; relation < 8; relation++) begin : g_relation
    assign holds[relation] = ffgpu_pkg::compare(relation[2:0], value_i, reference_i);
  end

  // Never, less, equal, less or equal; and what each of them is not.
  always_comb begin
    assert (holds[3:0] == {less || equal, equal, less, 1'b0});
    assert (holds[7:4] == ~{1'b0, less, equal, less || equal});
  end

endmodule
