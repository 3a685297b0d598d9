// From the alpha test to the targets: stencil_depth and blend, each between the read and the store
// of its target. Quads without a live lane go no further.

module target_stages #(
  parameter int unsigned Entries = ffgpu_registers_pkg::TargetQuads
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  ffgpu_pipe_pkg::draw_state_t     state_0_i,
  input  ffgpu_pipe_pkg::draw_state_t     state_1_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pkg::quad_t                in_data_i,

  // Quads that ended, by their tags: before the depth target, between the two, behind both.
  output logic [2:0]                      ends_0_o,
  output logic [2:0]                      ends_1_o,
  // By tags: of a quad that may have ended a store waits for its memory.
  output logic [1:0]                      waits_o,

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

  ffgpu_pkg::target_quad_t         depth_quad, color_quad;
  ffgpu_pkg::written_quad_t        depth_written, color_written;
  ffgpu_pkg::quad_t                tested, colored;
  ffgpu_pkg::stencil_depth_state_t depth_state_0, depth_state_1;
  ffgpu_pkg::blend_state_t         blend_state_0, blend_state_1;
  logic lives, read_ready, depth_valid, depth_ready, depth_written_valid, depth_written_ready;
  logic tested_valid, tested_ready, tested_lives, color_read_ready, color_valid, color_ready;
  logic color_written_valid, color_written_ready, colored_valid, depth_stored, color_stored;
  logic [2:0] ends;
  logic [1:0] depth_waits, color_waits;

  assign depth_state_0 = state_0_i.stencil_depth;
  assign depth_state_1 = state_1_i.stencil_depth;
  assign blend_state_0 = state_0_i.blend;
  assign blend_state_1 = state_1_i.blend;

  assign lives      = in_data_i.live != 4'd0;
  assign in_ready_o = read_ready || !lives;

  target_read #(
    .Entries(Entries)
  ) u_depth_read (
    .clk_i,
    .rst_ni,
    .place_0_i       (state_0_i.depth_place),
    .place_1_i       (state_1_i.depth_place),
    .format_0_i      (depth_state_0.format),
    .format_1_i      (depth_state_1.format),
    .in_valid_i      (in_valid_i && lives),
    .in_ready_o      (read_ready),
    .in_data_i,
    .out_valid_o     (depth_valid),
    .out_ready_i     (depth_ready),
    .out_data_o      (depth_quad),
    .stored_i        (depth_stored),
    .request_valid_o (depth_request_valid_o),
    .request_ready_i (depth_request_ready_i),
    .request_o       (depth_request_o),
    .response_valid_i(depth_response_valid_i),
    .response_ready_o(depth_response_ready_o),
    .response_i      (depth_response_i)
  );
  stencil_depth u_stencil_depth (
    .clk_i,
    .rst_ni,
    .state_0_i  (depth_state_0),
    .state_1_i  (depth_state_1),
    .in_valid_i (depth_valid),
    .in_ready_o (depth_ready),
    .in_data_i  (depth_quad),
    .out_valid_o(depth_written_valid),
    .out_ready_i(depth_written_ready),
    .out_data_o (depth_written)
  );
  target_write u_depth_write (
    .clk_i,
    .rst_ni,
    .place_0_i    (state_0_i.depth_place),
    .place_1_i    (state_1_i.depth_place),
    .format_0_i   (depth_state_0.format),
    .format_1_i   (depth_state_1.format),
    .in_valid_i   (depth_written_valid),
    .in_ready_o   (depth_written_ready),
    .in_data_i    (depth_written),
    .out_valid_o  (tested_valid),
    .out_ready_i  (tested_ready),
    .out_data_o   (tested),
    .stored_o     (depth_stored),
    .waits_o      (depth_waits),
    .store_valid_o(depth_store_valid_o),
    .store_ready_i(depth_store_ready_i),
    .store_o      (depth_store_o)
  );

  assign tested_lives = tested.live != 4'd0;
  assign tested_ready = color_read_ready || !tested_lives;

  target_read #(
    .Entries(Entries)
  ) u_color_read (
    .clk_i,
    .rst_ni,
    .place_0_i       (state_0_i.color_place),
    .place_1_i       (state_1_i.color_place),
    .format_0_i      (blend_state_0.format),
    .format_1_i      (blend_state_1.format),
    .in_valid_i      (tested_valid && tested_lives),
    .in_ready_o      (color_read_ready),
    .in_data_i       (tested),
    .out_valid_o     (color_valid),
    .out_ready_i     (color_ready),
    .out_data_o      (color_quad),
    .stored_i        (color_stored),
    .request_valid_o (color_request_valid_o),
    .request_ready_i (color_request_ready_i),
    .request_o       (color_request_o),
    .response_valid_i(color_response_valid_i),
    .response_ready_o(color_response_ready_o),
    .response_i      (color_response_i)
  );
  blend u_blend (
    .clk_i,
    .rst_ni,
    .state_0_i  (blend_state_0),
    .state_1_i  (blend_state_1),
    .in_valid_i (color_valid),
    .in_ready_o (color_ready),
    .in_data_i  (color_quad),
    .out_valid_o(color_written_valid),
    .out_ready_i(color_written_ready),
    .out_data_o (color_written)
  );
  target_write u_color_write (
    .clk_i,
    .rst_ni,
    .place_0_i    (state_0_i.color_place),
    .place_1_i    (state_1_i.color_place),
    .format_0_i   (blend_state_0.format),
    .format_1_i   (blend_state_1.format),
    .in_valid_i   (color_written_valid),
    .in_ready_o   (color_written_ready),
    .in_data_i    (color_written),
    .out_valid_o  (colored_valid),
    .out_ready_i  (1'b1),
    .out_data_o   (colored),
    .stored_o     (color_stored),
    .waits_o      (color_waits),
    .store_valid_o(color_store_valid_o),
    .store_ready_i(color_store_ready_i),
    .store_o      (color_store_o)
  );

  assign ends     = {colored_valid, tested_valid && !tested_lives, in_valid_i && !lives};
  assign waits_o  = depth_waits | color_waits;
  assign ends_1_o = ends & {colored.tag, tested.tag, in_data_i.tag};
  assign ends_0_o = ends & ~{colored.tag, tested.tag, in_data_i.tag};

endmodule
