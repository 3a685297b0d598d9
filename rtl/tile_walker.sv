// Traversal: the quads of a tile of 32x32 pixels that a primitive covers, block by block of 8x8,
// rows from the lower left.
//
// A cycle a block, and one more for each quad of the blocks that the edges and the box touch: a
// quad follows each cycle in which one has live pixels. Equals ffgpu::cover_tile_scalar() in
// model/raster/coverage.cpp.

module tile_walker (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     in_valid_i,
  output logic                     in_ready_o,
  input  ffgpu_pkg::tile_edges_t   in_data_i,

  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output ffgpu_pkg::covered_quad_t out_data_o
);

  localparam int unsigned Edges = ffgpu_pkg::Edges;
  localparam int unsigned StepWidth = ffgpu_pkg::EdgeStepWidth;

  ffgpu_pkg::tile_edges_t   walk_q;
  ffgpu_pkg::covered_quad_t covered;
  logic                     active_q, in_block_q, start, touches, last_block, leaves_block;
  logic                     next_row, quad_valid, quad_ready, steps;
  logic [3:0]               block_q, quad_q;  // y, x
  logic [Edges-1:0]         touches_edge;
  logic [Edges*4-1:0]       inside_edge;
  logic [3:0]               inside_box, inside_edges, live;
  logic [13:0]              block_x, block_y, quad_x, quad_y;

  assign in_ready_o = !active_q;
  assign start      = in_valid_i && in_ready_o;

  assign block_x = {1'b0, walk_q.tile_x} + {9'd0, block_q[1:0], 3'd0};
  assign block_y = {1'b0, walk_q.tile_y} + {9'd0, block_q[3:2], 3'd0};
  assign quad_x  = block_x + {11'd0, quad_q[1:0], 1'b0};
  assign quad_y  = block_y + {11'd0, quad_q[3:2], 1'b0};

  for (genvar i = 0; i < Edges; i++) begin : g_edge
    logic       is_used, touches_block;
    logic [3:0] pixels;

    tile_edge u_edge (
      .clk_i,
      .start_i        (start),
      .start_a_i      (in_data_i.a[StepWidth*i +: StepWidth]),
      .start_b_i      (in_data_i.b[StepWidth*i +: StepWidth]),
      .start_c_i      (in_data_i.c[ffgpu_pkg::EdgeWidth*i +: ffgpu_pkg::EdgeWidth]),
      .start_x_i      (in_data_i.tile_x),
      .start_y_i      (in_data_i.tile_y),
      .next_block_i   (leaves_block),
      .next_row_i     (next_row),
      .quad_x_i       (quad_q[1:0]),
      .quad_y_i       (quad_q[3:2]),
      .touches_block_o(touches_block),
      .inside_o       (pixels)
    );
    assign is_used               = i < walk_q.edge_count;
    assign touches_edge[i]       = !is_used || touches_block;
    assign inside_edge[4*i +: 4] = is_used ? pixels : 4'b1111;
  end

  assign touches = touches_edge == 4'b1111 && block_x < walk_q.box_x1 && block_y < walk_q.box_y1 &&
    block_x + 14'd8 > walk_q.box_x0 && block_y + 14'd8 > walk_q.box_y0;

  for (genvar lane = 0; lane < 4; lane++) begin : g_lane
    logic [13:0] x, y;
    assign x = quad_x + (lane % 2 == 1 ? 14'd1 : 14'd0);
    assign y = quad_y + (lane / 2 == 1 ? 14'd1 : 14'd0);
    assign inside_box[lane] = x >= walk_q.box_x0 && x < walk_q.box_x1 && y >= walk_q.box_y0 &&
      y < walk_q.box_y1;
  end
  assign inside_edges = inside_edge[3:0] & inside_edge[7:4] & inside_edge[11:8] &
    inside_edge[15:12];
  assign live = inside_edges & inside_box;

  assign quad_valid   = active_q && in_block_q && live != 4'd0;
  assign steps        = in_block_q && (live == 4'd0 || quad_ready);
  assign leaves_block = active_q && (in_block_q ? steps && quad_q == 4'd15 : !touches);
  assign last_block   = block_q == 4'd15;
  assign next_row     = leaves_block && block_q[1:0] == 2'd3;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
    end else if (start) begin
      active_q <= 1'b1;
    end else if (leaves_block) begin
      active_q <= !last_block;
    end
  end
  // Where it is needs no reset: active_q guards it.
  always_ff @(posedge clk_i) begin
    if (start) begin
      walk_q     <= in_data_i;
      block_q    <= 4'd0;
      quad_q     <= 4'd0;
      in_block_q <= 1'b0;
    end else if (leaves_block) begin
      block_q    <= block_q + 4'd1;
      quad_q     <= 4'd0;
      in_block_q <= 1'b0;
    end else begin
      in_block_q <= active_q;
      if (steps) begin
        quad_q <= quad_q + 4'd1;
      end
    end
  end

  always_comb begin
    covered.tag          = walk_q.tag;
    covered.key          = walk_q.key;
    covered.front_facing = walk_q.front_facing;
    covered.x            = {quad_x[12:1], 1'b0};
    covered.y            = {quad_y[12:1], 1'b0};
    covered.live         = live;
  end

  pipeline_register #(
    .Width($bits(covered))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (quad_valid),
    .in_ready_o (quad_ready),
    .in_data_i  (covered),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
