// One edge of a walk through a tile: the edge function at the present block, and which of a quad's
// pixels are inside.
//
// The function's value at the block's lower left pixel is kept and moved by adding. Equals
// ffgpu::Edge::at() in model/raster/edge.h.

module tile_edge (
  input  logic                                       clk_i,

  // A new walk: the edge, and where the tile begins.
  input  logic                                       start_i,
  input  logic signed [ffgpu_pkg::EdgeStepWidth-1:0] start_a_i,
  input  logic signed [ffgpu_pkg::EdgeStepWidth-1:0] start_b_i,
  input  logic signed [ffgpu_pkg::EdgeWidth-1:0]     start_c_i,
  input  logic [12:0]                                start_x_i,
  input  logic [12:0]                                start_y_i,

  // To the next block of the row, or to the first of the next row.
  input  logic                                       next_block_i,
  input  logic                                       next_row_i,

  input  logic [1:0]                                 quad_x_i,
  input  logic [1:0]                                 quad_y_i,

  output logic                                       touches_block_o,
  output logic [3:0]                                 inside_o
);

  localparam int unsigned Width = 47;  // of c, of a x + b y, and a sign

  logic signed [Width-1:0] a_q, b_q, row_q, block_q, next_row, gain, most, quad, start_value;
  logic signed [Width-1:0] start_a, start_b, start_c, start_x, start_y;

  assign start_a     = {{Width-ffgpu_pkg::EdgeStepWidth{start_a_i[22]}}, start_a_i};
  assign start_b     = {{Width-ffgpu_pkg::EdgeStepWidth{start_b_i[22]}}, start_b_i};
  assign start_c     = {{Width-ffgpu_pkg::EdgeWidth{start_c_i[44]}}, start_c_i};
  assign start_x     = {34'd0, start_x_i};
  assign start_y     = {34'd0, start_y_i};
  assign start_value = start_a * start_x + start_b * start_y + start_c;
  assign next_row    = row_q + (b_q <<< 3);

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      a_q     <= start_a;
      b_q     <= start_b;
      row_q   <= start_value;
      block_q <= start_value;
    end else if (next_row_i) begin
      row_q   <= next_row;
      block_q <= next_row;
    end else if (next_block_i) begin
      block_q <= block_q + (a_q <<< 3);
    end
  end

  // The most that the function comes to in the block.
  assign gain = (a_q[Width-1] ? 47'sd0 : (a_q <<< 3) - a_q) +
    (b_q[Width-1] ? 47'sd0 : (b_q <<< 3) - b_q);
  assign most            = block_q + gain;
  assign touches_block_o = !most[Width-1];

  always_comb begin
    quad = block_q;
    if (quad_x_i[0]) begin
      quad = quad + (a_q <<< 1);
    end
    if (quad_x_i[1]) begin
      quad = quad + (a_q <<< 2);
    end
    if (quad_y_i[0]) begin
      quad = quad + (b_q <<< 1);
    end
    if (quad_y_i[1]) begin
      quad = quad + (b_q <<< 2);
    end
  end

  for (genvar lane = 0; lane < 4; lane++) begin : g_lane
    logic signed [Width-1:0] value;
    assign value = quad + (lane % 2 == 1 ? a_q : 47'sd0) + (lane / 2 == 1 ? b_q : 47'sd0);
    assign inside_o[lane] = !value[Width-1];
  end

endmodule
