// The tiles of 32x32 pixels that a primitive's box touches, row by row from the lower left.
//
// Latency 1, one tile a cycle.

module tile_sequence (
  input  logic                          clk_i,
  input  logic                          rst_ni,

  input  logic                          in_valid_i,
  output logic                          in_ready_o,
  input  ffgpu_pipe_pkg::setup_record_t in_data_i,

  output logic                          out_valid_o,
  input  logic                          out_ready_i,
  output ffgpu_pkg::tile_edges_t        out_data_o,

  // The primitive under way, until the next one is taken.
  output ffgpu_pipe_pkg::setup_record_t record_o
);

  localparam int unsigned TileBits = 5;

  ffgpu_pipe_pkg::setup_record_t record_q;
  logic                          active_q, steps, last_column, last_row;
  logic [7:0]                    column_q, row_q;
  logic [13:0]                   last_x, last_y;

  assign last_x      = record_q.box_x1 - 14'd1;
  assign last_y      = record_q.box_y1 - 14'd1;
  assign last_column = column_q == last_x[12:TileBits];
  assign last_row    = row_q == last_y[12:TileBits];
  assign steps       = out_valid_o && out_ready_i;
  assign in_ready_o  = !active_q;
  assign out_valid_o = active_q;
  assign record_o    = record_q;

  always_comb begin
    out_data_o.tag          = record_q.tag;
    out_data_o.key          = record_q.key;
    out_data_o.front_facing = record_q.front_facing;
    out_data_o.tile_x       = {column_q, {TileBits{1'b0}}};
    out_data_o.tile_y       = {row_q, {TileBits{1'b0}}};
    out_data_o.box_x0       = record_q.box_x0;
    out_data_o.box_y0       = record_q.box_y0;
    out_data_o.box_x1       = record_q.box_x1;
    out_data_o.box_y1       = record_q.box_y1;
    out_data_o.edge_count   = record_q.edge_count;
    out_data_o.a            = record_q.a;
    out_data_o.b            = record_q.b;
    out_data_o.c            = record_q.c;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
    end else if (in_valid_i && in_ready_o) begin
      active_q <= 1'b1;
    end else if (steps && last_column && last_row) begin
      active_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (in_valid_i && in_ready_o) begin
      record_q <= in_data_i;
      column_q <= in_data_i.box_x0[12:TileBits];
      row_q    <= in_data_i.box_y0[12:TileBits];
    end else if (steps) begin
      column_q <= last_column ? record_q.box_x0[12:TileBits] : column_q + 8'd1;
      row_q    <= last_column ? row_q + 8'd1 : row_q;
    end
  end

endmodule
