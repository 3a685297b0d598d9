// The texture unit: quads' coordinates in, a sample for each live lane out, in their order.
//
//   texture_banks > level_of_detail > texel_address > texel_fetch > texel_supply > texel_decode
//   > texel_gather > filter_tree
//
// A texel a cycle. A sample's place: lane in bits 0 and 1, the unit in 2 to 4, in bit 5 whether it
// is the quad's last unit.

module texture_unit #(
  parameter int unsigned LineBits = ffgpu_registers_pkg::LineBits,
  parameter int unsigned FillBits = ffgpu_registers_pkg::FillBits,
  parameter int unsigned SetBits = ffgpu_registers_pkg::CacheSetBits,  // of the texel cache
  parameter int unsigned QueueDepth = ffgpu_registers_pkg::TexelQueue
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic                            invalidate_i,

  input  logic [8*1824-1:0]               contexts_0_i,
  input  logic [8*1824-1:0]               contexts_1_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pipe_pkg::sample_request_t in_data_i,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output ffgpu_pkg::texel_t               out_data_o,

  output logic                            request_valid_o,
  input  logic                            request_ready_i,
  output logic [31:0]                     request_address_o,
  output logic [FillBits-1:0]             request_fill_o,
  input  logic                            response_valid_i,
  input  logic [FillBits-1:0]             response_fill_i,
  input  logic [(8<<LineBits)-1:0]        response_line_i
);

  localparam int unsigned SideDepth = 8;
  localparam int unsigned FilterDepth = 64;

  ffgpu_pipe_pkg::texture_context_t  bank_0, bank_1;
  ffgpu_pipe_pkg::sample_request_t   request;
  ffgpu_pkg::texture_state_t         state_0, state_1;
  ffgpu_texture_pkg::level_quad_t    level_quad;
  ffgpu_texture_pkg::quad_levels_t   levels;
  ffgpu_texture_pkg::address_quad_t  address_quad;
  ffgpu_texture_pkg::texel_request_t texel_request;
  ffgpu_pipe_pkg::fetched_texel_t    fetched;
  ffgpu_pipe_pkg::filter_note_t      note, filter;
  ffgpu_pkg::texel_block_t           block;
  ffgpu_pkg::texel_t                 texel;
  ffgpu_pkg::filter_level_t          level;
  logic request_valid, request_ready, level_ready, side_ready, levels_valid, side_valid;
  logic address_ready, texels_valid, texels_ready, fetched_valid, fetched_ready;
  logic note_valid, note_ready, filter_valid, filter_ready, block_valid, block_ready;
  logic texel_valid, texel_ready, gathered_valid, gathered_ready;
  logic [3:0]   side_live;
  logic [383:0] side_coordinates;

  texture_banks u_banks (
    .clk_i,
    .rst_ni,
    .contexts_0_i,
    .contexts_1_i,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o   (request_valid),
    .out_ready_i   (request_ready),
    .out_data_o    (request),
    .sampled_i     (out_valid_o && out_ready_i),
    .sampled_bank_i(out_data_o.tag),
    .bank_0_o      (bank_0),
    .bank_1_o      (bank_1)
  );
  assign state_0 = {bank_0.image, bank_0.sampler};
  assign state_1 = {bank_1.image, bank_1.sampler};

  // Levels, and the coordinates beside them.
  assign request_ready = level_ready && side_ready;
  assign level_quad    = {request.tag, 6'd0, request.last_unit, request.unit, 1'b1,
                          request.coordinates};

  level_of_detail u_levels (
    .clk_i,
    .rst_ni,
    .state_0_i  (state_0),
    .state_1_i  (state_1),
    .in_valid_i (request_valid && side_ready),
    .in_ready_o (level_ready),
    .in_data_i  (level_quad),
    .out_valid_o(levels_valid),
    .out_ready_i(address_ready && side_valid),
    .out_data_o (levels)
  );
  fifo #(
    .Width(4 + 384),
    .Depth(SideDepth)
  ) u_side (
    .clk_i,
    .rst_ni,
    .in_valid_i (request_valid && level_ready),
    .in_ready_o (side_ready),
    .in_data_i  ({request.live, request.coordinates}),
    .out_valid_o(side_valid),
    .out_ready_i(address_ready && levels_valid),
    .out_data_o ({side_live, side_coordinates})
  );
  assign address_quad = {side_live, 12'd0, side_coordinates, levels};

  texel_address u_address (
    .clk_i,
    .rst_ni,
    .state_0_i  (state_0),
    .state_1_i  (state_1),
    .in_valid_i (levels_valid && side_valid),
    .in_ready_o (address_ready),
    .in_data_i  (address_quad),
    .out_valid_o(texels_valid),
    .out_ready_i(texels_ready),
    .out_data_o (texel_request)
  );
  texel_fetch u_fetch (
    .clk_i,
    .rst_ni,
    .bank_0_i      (bank_0),
    .bank_1_i      (bank_1),
    .in_valid_i    (texels_valid),
    .in_ready_o    (texels_ready),
    .in_data_i     (texel_request),
    .out_valid_o   (fetched_valid),
    .out_ready_i   (fetched_ready),
    .out_data_o    (fetched),
    .filter_valid_o(note_valid),
    .filter_ready_i(note_ready),
    .filter_o      (note)
  );
  fifo #(
    .Width($bits(note)),
    .Depth(FilterDepth)
  ) u_filters (
    .clk_i,
    .rst_ni,
    .in_valid_i (note_valid),
    .in_ready_o (note_ready),
    .in_data_i  (note),
    .out_valid_o(filter_valid),
    .out_ready_i(filter_ready),
    .out_data_o (filter)
  );
  texel_supply #(
    .LineBits  (LineBits),
    .FillBits  (FillBits),
    .SetBits   (SetBits),
    .QueueDepth(QueueDepth)
  ) u_supply (
    .clk_i,
    .rst_ni,
    .invalidate_i,
    .bank_0_i   (bank_0),
    .bank_1_i   (bank_1),
    .in_valid_i (fetched_valid),
    .in_ready_o (fetched_ready),
    .in_data_i  (fetched),
    .out_valid_o(block_valid),
    .out_ready_i(block_ready),
    .out_data_o (block),
    .request_valid_o,
    .request_ready_i,
    .request_address_o,
    .request_fill_o,
    .response_valid_i,
    .response_fill_i,
    .response_line_i
  );
  texel_decode u_decode (
    .clk_i,
    .rst_ni,
    .in_valid_i (block_valid),
    .in_ready_o (block_ready),
    .in_data_i  (block),
    .out_valid_o(texel_valid),
    .out_ready_i(texel_ready),
    .out_data_o (texel)
  );
  texel_gather u_gather (
    .clk_i,
    .rst_ni,
    .in_valid_i    (texel_valid),
    .in_ready_o    (texel_ready),
    .in_data_i     (texel),
    .filter_valid_i(filter_valid),
    .filter_ready_o(filter_ready),
    .filter_i      (filter),
    .out_valid_o   (gathered_valid),
    .out_ready_i   (gathered_ready),
    .out_data_o    (level)
  );
  filter_tree u_filter (
    .clk_i,
    .rst_ni,
    .in_valid_i (gathered_valid),
    .in_ready_o (gathered_ready),
    .in_data_i  (level),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
