// The fragment pipe as the host clocks it: what the memory's ports say in a cycle is handed over in
// the cycle before and stands in flops. So nothing of the pipe hangs on an input by gates alone, and
// the host's processor computes each gate once a cycle, at the edge. Not part of the pipe: its
// cycles are the same.
//
// Inputs `_next_i` are those of the next cycle; all else is fragment_pipe's.

module pipe_ports #(
  parameter int unsigned LineBits = ffgpu_registers_pkg::LineBits,
  parameter int unsigned FillBits = ffgpu_registers_pkg::FillBits,
  parameter int unsigned SetBits = ffgpu_registers_pkg::CacheSetBits,
  parameter int unsigned QueueDepth = ffgpu_registers_pkg::TexelQueue,
  parameter int unsigned TargetQuads = ffgpu_registers_pkg::TargetQuads
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic                            state_write_i,
  input  logic                            state_tag_i,
  input  ffgpu_pipe_pkg::draw_state_t     state_i,
  input  logic [8*1824-1:0]               contexts_i,
  output logic [1:0]                      idle_o,
  input  logic                            invalidate_i,

  input  logic                            plane_valid_i,
  output logic                            plane_ready_o,
  input  ffgpu_pipe_pkg::plane_write_t    plane_i,
  input  logic                            record_valid_i,
  output logic                            record_ready_o,
  input  ffgpu_pipe_pkg::setup_record_t   record_i,

  output logic                            texel_request_valid_o,
  input  logic                            texel_request_ready_next_i,
  output logic [31:0]                     texel_request_address_o,
  output logic [FillBits-1:0]             texel_request_fill_o,
  input  logic                            texel_response_valid_next_i,
  input  logic [FillBits-1:0]             texel_response_fill_next_i,
  input  logic [(8<<LineBits)-1:0]        texel_response_line_next_i,

  output logic                            depth_request_valid_o,
  input  logic                            depth_request_ready_next_i,
  output ffgpu_pipe_pkg::target_request_t depth_request_o,
  input  logic                            depth_response_valid_next_i,
  output logic                            depth_response_ready_o,
  input  logic [127:0]                    depth_response_next_i,
  output logic                            depth_store_valid_o,
  input  logic                            depth_store_ready_next_i,
  output ffgpu_pipe_pkg::target_store_t   depth_store_o,

  output logic                            color_request_valid_o,
  input  logic                            color_request_ready_next_i,
  output ffgpu_pipe_pkg::target_request_t color_request_o,
  input  logic                            color_response_valid_next_i,
  output logic                            color_response_ready_o,
  input  logic [127:0]                    color_response_next_i,
  output logic                            color_store_valid_o,
  input  logic                            color_store_ready_next_i,
  output ffgpu_pipe_pkg::target_store_t   color_store_o
);

  logic                     texel_request_ready_q, texel_response_valid_q;
  logic                     depth_request_ready_q, depth_response_valid_q, depth_store_ready_q;
  logic                     color_request_ready_q, color_response_valid_q, color_store_ready_q;
  logic [FillBits-1:0]      texel_response_fill_q;
  logic [(8<<LineBits)-1:0] texel_response_line_q;
  logic [127:0]             depth_response_q, color_response_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      texel_response_valid_q <= 1'b0;
      depth_response_valid_q <= 1'b0;
      color_response_valid_q <= 1'b0;
    end else begin
      texel_response_valid_q <= texel_response_valid_next_i;
      depth_response_valid_q <= depth_response_valid_next_i;
      color_response_valid_q <= color_response_valid_next_i;
    end
  end
  always_ff @(posedge clk_i) begin
    texel_request_ready_q <= texel_request_ready_next_i;
    depth_request_ready_q <= depth_request_ready_next_i;
    depth_store_ready_q   <= depth_store_ready_next_i;
    color_request_ready_q <= color_request_ready_next_i;
    color_store_ready_q   <= color_store_ready_next_i;
    if (texel_response_valid_next_i) begin
      texel_response_fill_q <= texel_response_fill_next_i;
      texel_response_line_q <= texel_response_line_next_i;
    end
    if (depth_response_valid_next_i) begin
      depth_response_q <= depth_response_next_i;
    end
    if (color_response_valid_next_i) begin
      color_response_q <= color_response_next_i;
    end
  end

  fragment_pipe #(
    .LineBits   (LineBits),
    .FillBits   (FillBits),
    .SetBits    (SetBits),
    .QueueDepth (QueueDepth),
    .TargetQuads(TargetQuads)
  ) u_pipe (
    .clk_i,
    .rst_ni,
    .state_write_i,
    .state_tag_i,
    .state_i,
    .contexts_i,
    .idle_o,
    .invalidate_i,
    .plane_valid_i,
    .plane_ready_o,
    .plane_i,
    .record_valid_i,
    .record_ready_o,
    .record_i,
    .texel_request_valid_o,
    .texel_request_ready_i (texel_request_ready_q),
    .texel_request_address_o,
    .texel_request_fill_o,
    .texel_response_valid_i(texel_response_valid_q),
    .texel_response_fill_i (texel_response_fill_q),
    .texel_response_line_i (texel_response_line_q),
    .depth_request_valid_o,
    .depth_request_ready_i (depth_request_ready_q),
    .depth_request_o,
    .depth_response_valid_i(depth_response_valid_q),
    .depth_response_ready_o,
    .depth_response_i      (depth_response_q),
    .depth_store_valid_o,
    .depth_store_ready_i   (depth_store_ready_q),
    .depth_store_o,
    .color_request_valid_o,
    .color_request_ready_i (color_request_ready_q),
    .color_request_o,
    .color_response_valid_i(color_response_valid_q),
    .color_response_ready_o,
    .color_response_i      (color_response_q),
    .color_store_valid_o,
    .color_store_ready_i   (color_store_ready_q),
    .color_store_o
  );

endmodule
