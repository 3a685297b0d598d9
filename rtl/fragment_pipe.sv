// The fragment pipe: primitives after set-up in, requests to memory out.
//
//   record_store, raster_front > interpolator > texture_unit > sample_collect > shading_stages
//   > target_stages
//
// Quads stay in their order. A primitive's planes are taken before its record. A draw's registers
// stand in the bank of its tag while it is inside; idle_o says that no quad of a tag is.
// docs/rtl.md has the diagram.

module fragment_pipe #(
  parameter int unsigned LineBits = ffgpu_registers_pkg::LineBits,
  parameter int unsigned FillBits = ffgpu_registers_pkg::FillBits,
  parameter int unsigned SetBits = ffgpu_registers_pkg::CacheSetBits,  // of the texel cache
  parameter int unsigned QueueDepth = ffgpu_registers_pkg::TexelQueue,  // texels
  parameter int unsigned TargetQuads = ffgpu_registers_pkg::TargetQuads  // between read and store
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  // A draw's registers, into the bank of its tag while that is idle; no quad of a tag is inside.
  input  logic                            state_write_i,
  input  logic                            state_tag_i,
  input  ffgpu_pipe_pkg::draw_state_t     state_i,
  input  logic [8*1824-1:0]               contexts_i,  // texture_context_t, unit 0 lowest
  output logic [1:0]                      idle_o,
  input  logic                            invalidate_i,  // Textures changed; while all is idle.

  input  logic                            plane_valid_i,
  output logic                            plane_ready_o,
  input  ffgpu_pipe_pkg::plane_write_t    plane_i,
  input  logic                            record_valid_i,
  output logic                            record_ready_o,
  input  ffgpu_pipe_pkg::setup_record_t   record_i,

  // Lines of texels: asked for in any number, answered in any order.
  output logic                            texel_request_valid_o,
  input  logic                            texel_request_ready_i,
  output logic [31:0]                     texel_request_address_o,
  output logic [FillBits-1:0]             texel_request_fill_o,
  input  logic                            texel_response_valid_i,
  input  logic [FillBits-1:0]             texel_response_fill_i,
  input  logic [(8<<LineBits)-1:0]        texel_response_line_i,

  // Targets: reads answered in order, stores with byte enables.
  output logic                            depth_request_valid_o,
  input  logic                            depth_request_ready_i,
  output ffgpu_pipe_pkg::target_request_t depth_request_o,
  input  logic                            depth_response_valid_i,
  output logic                            depth_response_ready_o,
  input  logic [127:0]                    depth_response_i,
  output logic                            depth_store_valid_o,
  input  logic                            depth_store_ready_i,
  output ffgpu_pipe_pkg::target_store_t   depth_store_o,

  output logic                            color_request_valid_o,
  input  logic                            color_request_ready_i,
  output ffgpu_pipe_pkg::target_request_t color_request_o,
  input  logic                            color_response_valid_i,
  output logic                            color_response_ready_o,
  input  logic [127:0]                    color_response_i,
  output logic                            color_store_valid_o,
  input  logic                            color_store_ready_i,
  output ffgpu_pipe_pkg::target_store_t   color_store_o
);

  localparam int unsigned PendingDepth = ffgpu_registers_pkg::PendingQuads;
  // As many samples as a quad can have: its first units' wait here for its last unit's request.
  localparam int unsigned SampleDepth = 32;

  ffgpu_pipe_pkg::draw_state_t     state_0, state_1;
  logic [8*1824-1:0]               contexts_0, contexts_1;
  ffgpu_pipe_pkg::slotted_quad_t   quad;
  ffgpu_pipe_pkg::sample_request_t request;
  ffgpu_pipe_pkg::pending_quad_t   pending, waiting;
  ffgpu_pkg::texel_t               sample, kept_sample;
  ffgpu_pkg::shade_quad_t          sampled;
  ffgpu_pkg::quad_t                shaded;
  ffgpu_pipe_pkg::plane_t          first_plane, second_plane;
  logic [4*129-1:0] headers;
  logic [4*64-1:0]  q_scales;
  logic [5:0]       first_attribute, second_attribute;
  logic [1:0]       slot, walked_slot, done_slot, first_slot, second_slot;
  logic [2:0]       ends_0, ends_1;
  logic [1:0]       waits;
  logic record_taken, store_ready, front_ready, walking, found, walked_tag, done;
  logic quad_valid, quad_ready, request_valid, request_ready, pending_valid, pending_ready;
  logic waiting_valid, waiting_ready, sample_valid, sample_ready, kept_valid, kept_ready;
  logic sampled_valid, sampled_ready, shaded_valid, shaded_ready;

  draw_registers u_registers (
    .clk_i,
    .write_i     (state_write_i),
    .tag_i       (state_tag_i),
    .state_i,
    .contexts_i,
    .state_0_o   (state_0),
    .state_1_o   (state_1),
    .contexts_0_o(contexts_0),
    .contexts_1_o(contexts_1)
  );

  assign record_ready_o = store_ready && front_ready;
  assign record_taken   = record_valid_i && record_ready_o;

  record_store u_records (
    .clk_i,
    .rst_ni,
    .plane_valid_i,
    .plane_ready_o,
    .plane_i,
    .record_taken_i    (record_taken),
    .header_i          (record_i.shading),
    .record_ready_o    (store_ready),
    .record_slot_o     (slot),
    .walking_i         (walking),
    .walked_slot_i     (walked_slot),
    .found_i           (found),
    .done_i            (done),
    .done_slot_i       (done_slot),
    .headers_o         (headers),
    .q_scales_o        (q_scales),
    .first_slot_i      (first_slot),
    .first_attribute_i (first_attribute),
    .first_plane_o     (first_plane),
    .second_slot_i     (second_slot),
    .second_attribute_i(second_attribute),
    .second_plane_o    (second_plane)
  );
  raster_front u_front (
    .clk_i,
    .rst_ni,
    .in_valid_i (record_valid_i && store_ready),
    .in_ready_o (front_ready),
    .in_data_i  (record_i),
    .in_slot_i  (slot),
    .out_valid_o(quad_valid),
    .out_ready_i(quad_ready),
    .out_data_o (quad),
    .busy_o     (walking),
    .found_o    (found),
    .tag_o      (walked_tag),
    .slot_o     (walked_slot)
  );
  interpolator u_interpolator (
    .clk_i,
    .rst_ni,
    .carried_0_i       (state_0.carried),
    .carried_1_i       (state_1.carried),
    .in_valid_i        (quad_valid),
    .in_ready_o        (quad_ready),
    .in_data_i         (quad),
    .headers_i         (headers),
    .q_scales_i        (q_scales),
    .first_slot_o      (first_slot),
    .first_attribute_o (first_attribute),
    .first_plane_i     (first_plane),
    .second_slot_o     (second_slot),
    .second_attribute_o(second_attribute),
    .second_plane_i    (second_plane),
    .done_o            (done),
    .done_slot_o       (done_slot),
    .request_valid_o   (request_valid),
    .request_ready_i   (request_ready),
    .request_o         (request),
    .out_valid_o       (pending_valid),
    .out_ready_i       (pending_ready),
    .out_data_o        (pending)
  );

  // Samples, and the quads that wait for them.
  texture_unit #(
    .LineBits  (LineBits),
    .FillBits  (FillBits),
    .SetBits   (SetBits),
    .QueueDepth(QueueDepth)
  ) u_texture (
    .clk_i,
    .rst_ni,
    .invalidate_i,
    .contexts_0_i     (contexts_0),
    .contexts_1_i     (contexts_1),
    .in_valid_i       (request_valid),
    .in_ready_o       (request_ready),
    .in_data_i        (request),
    .out_valid_o      (sample_valid),
    .out_ready_i      (sample_ready),
    .out_data_o       (sample),
    .request_valid_o  (texel_request_valid_o),
    .request_ready_i  (texel_request_ready_i),
    .request_address_o(texel_request_address_o),
    .request_fill_o   (texel_request_fill_o),
    .response_valid_i (texel_response_valid_i),
    .response_fill_i  (texel_response_fill_i),
    .response_line_i  (texel_response_line_i)
  );
  fifo #(
    .Width($bits(sample)),
    .Depth(SampleDepth)
  ) u_samples (
    .clk_i,
    .rst_ni,
    .in_valid_i (sample_valid),
    .in_ready_o (sample_ready),
    .in_data_i  (sample),
    .out_valid_o(kept_valid),
    .out_ready_i(kept_ready),
    .out_data_o (kept_sample)
  );
  fifo #(
    .Width($bits(pending)),
    .Depth(PendingDepth)
  ) u_pending (
    .clk_i,
    .rst_ni,
    .in_valid_i (pending_valid),
    .in_ready_o (pending_ready),
    .in_data_i  (pending),
    .out_valid_o(waiting_valid),
    .out_ready_i(waiting_ready),
    .out_data_o (waiting)
  );
  sample_collect u_collect (
    .clk_i,
    .sampled_units_0_i(state_0.sampled_units),
    .sampled_units_1_i(state_1.sampled_units),
    .in_valid_i       (waiting_valid),
    .in_ready_o       (waiting_ready),
    .in_data_i        (waiting),
    .sample_valid_i   (kept_valid),
    .sample_ready_o   (kept_ready),
    .sample_i         (kept_sample),
    .out_valid_o      (sampled_valid),
    .out_ready_i      (sampled_ready),
    .out_data_o       (sampled)
  );

  shading_stages u_shading (
    .clk_i,
    .rst_ni,
    .state_0_i  (state_0),
    .state_1_i  (state_1),
    .in_valid_i (sampled_valid),
    .in_ready_o (sampled_ready),
    .in_data_i  (sampled),
    .out_valid_o(shaded_valid),
    .out_ready_i(shaded_ready),
    .out_data_o (shaded)
  );
  target_stages #(
    .Entries(TargetQuads)
  ) u_targets (
    .clk_i,
    .rst_ni,
    .state_0_i (state_0),
    .state_1_i (state_1),
    .in_valid_i(shaded_valid),
    .in_ready_o(shaded_ready),
    .in_data_i (shaded),
    .ends_0_o  (ends_0),
    .ends_1_o  (ends_1),
    .waits_o   (waits),
    .depth_request_valid_o,
    .depth_request_ready_i,
    .depth_request_o,
    .depth_response_valid_i,
    .depth_response_ready_o,
    .depth_response_i,
    .depth_store_valid_o,
    .depth_store_ready_i,
    .depth_store_o,
    .color_request_valid_o,
    .color_request_ready_i,
    .color_request_o,
    .color_response_valid_i,
    .color_response_ready_o,
    .color_response_i,
    .color_store_valid_o,
    .color_store_ready_i,
    .color_store_o
  );
  draw_tracker u_tracker (
    .clk_i,
    .rst_ni,
    .walking_i(walking),
    .found_i  (found),
    .tag_i    (walked_tag),
    .ends_0_i (ends_0),
    .ends_1_i (ends_1),
    .waits_i  (waits),
    .idle_o
  );

endmodule
