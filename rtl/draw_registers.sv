// The registers of the draws that are inside, a bank a tag. A bank is written when no quad of its
// tag is inside, and stands from the next cycle on.

module draw_registers (
  input  logic                        clk_i,

  input  logic                        write_i,
  input  logic                        tag_i,
  input  ffgpu_pipe_pkg::draw_state_t state_i,
  input  logic [8*1824-1:0]           contexts_i,  // texture_context_t, unit 0 lowest

  output ffgpu_pipe_pkg::draw_state_t state_0_o,
  output ffgpu_pipe_pkg::draw_state_t state_1_o,
  output logic [8*1824-1:0]           contexts_0_o,
  output logic [8*1824-1:0]           contexts_1_o
);

  always_ff @(posedge clk_i) begin
    if (write_i && !tag_i) begin
      state_0_o    <= state_i;
      contexts_0_o <= contexts_i;
    end
    if (write_i && tag_i) begin
      state_1_o    <= state_i;
      contexts_1_o <= contexts_i;
    end
  end

endmodule
