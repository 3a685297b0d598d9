// From a primitive's record to its quads with their depths: tile_sequence, tile_walker,
// depth_plane.
//
// A quad a cycle within a block. The next primitive is taken when the walker is empty, so that the
// record under way is that of every quad that leaves the walker.

module raster_front (
  input  logic                          clk_i,
  input  logic                          rst_ni,

  input  logic                          in_valid_i,
  output logic                          in_ready_o,
  input  ffgpu_pipe_pkg::setup_record_t in_data_i,
  input  logic [ffgpu_pipe_pkg::SlotWidth-1:0] in_slot_i,  // where its planes are

  output logic                          out_valid_o,
  input  logic                          out_ready_i,
  output ffgpu_pipe_pkg::slotted_quad_t out_data_o,

  // A primitive is being walked; a quad of it has been found.
  output logic                          busy_o,
  output logic                          found_o,
  output logic                          tag_o,
  output logic [ffgpu_pipe_pkg::SlotWidth-1:0] slot_o
);

  localparam int unsigned SideDepth = ffgpu_registers_pkg::WalkedQuads;

  ffgpu_pipe_pkg::setup_record_t   record;
  ffgpu_pipe_pkg::shading_header_t shading;
  ffgpu_pkg::tile_edges_t          tile;
  ffgpu_pkg::covered_quad_t        covered, beside;
  ffgpu_pkg::depth_plane_quad_t    depth_quad;
  ffgpu_pkg::lane_depths_t         depths;
  ffgpu_pkg::quad_t                quad;
  logic tile_valid, tile_ready, covered_valid, covered_ready, depth_ready, side_ready;
  logic depths_valid, side_valid, joined, sequence_ready;
  logic [ffgpu_pipe_pkg::SlotWidth-1:0] slot_q, side_slot;

  assign busy_o     = !sequence_ready || !tile_ready || covered_valid;
  assign in_ready_o = !busy_o;
  assign tag_o      = record.tag;
  assign slot_o     = slot_q;
  assign shading    = record.shading;

  tile_sequence u_sequence (
    .clk_i,
    .rst_ni,
    .in_valid_i (in_valid_i && in_ready_o),
    .in_ready_o (sequence_ready),
    .in_data_i,
    .out_valid_o(tile_valid),
    .out_ready_i(tile_ready),
    .out_data_o (tile),
    .record_o   (record)
  );
  tile_walker u_walker (
    .clk_i,
    .rst_ni,
    .in_valid_i (tile_valid),
    .in_ready_o (tile_ready),
    .in_data_i  (tile),
    .out_valid_o(covered_valid),
    .out_ready_i(covered_ready),
    .out_data_o (covered)
  );

  always_ff @(posedge clk_i) begin
    if (in_valid_i && in_ready_o) begin
      slot_q <= in_slot_i;
    end
  end

  // The depth, and the quad beside it.
  assign covered_ready = depth_ready && side_ready;
  assign found_o       = covered_valid && covered_ready;
  assign depth_quad    = {covered.tag, 10'd0,
                          {2'd0, covered.x} - shading.x_reference,
                          {2'd0, covered.y} - shading.y_reference,
                          record.depth_origin, record.depth_dx, record.depth_dy,
                          record.depth_min, record.depth_max};

  depth_plane u_depth (
    .clk_i,
    .rst_ni,
    .in_valid_i (covered_valid && side_ready),
    .in_ready_o (depth_ready),
    .in_data_i  (depth_quad),
    .out_valid_o(depths_valid),
    .out_ready_i(out_ready_i && side_valid),
    .out_data_o (depths)
  );
  fifo #(
    .Width($bits(covered) + ffgpu_pipe_pkg::SlotWidth),
    .Depth(SideDepth)
  ) u_side (
    .clk_i,
    .rst_ni,
    .in_valid_i (covered_valid && depth_ready),
    .in_ready_o (side_ready),
    .in_data_i  ({slot_q, covered}),
    .out_valid_o(side_valid),
    .out_ready_i(out_ready_i && depths_valid),
    .out_data_o ({side_slot, beside})
  );

  assign joined      = depths_valid && side_valid;
  assign out_valid_o = joined;
  always_comb begin
    quad.tag          = beside.tag;
    quad.key          = beside.key;
    quad.x            = beside.x;
    quad.y            = beside.y;
    quad.live         = beside.live;
    quad.front_facing = beside.front_facing;
    quad.depth        = depths.depths;
    quad.coverage     = '1;
    quad.color        = '0;
  end
  assign out_data_o = {side_slot, quad};

endmodule
