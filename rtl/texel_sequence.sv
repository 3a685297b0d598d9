// A quad's live lanes one after the other, of each its probes, of each the finer level and then the
// coarser one, if it has a weight.
//
// A cycle each, and one between quads.

module texel_sequence (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     in_valid_i,
  output logic                     in_ready_o,
  input  ffgpu_texture_pkg::address_quad_t in_data_i,

  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output ffgpu_texture_pkg::texel_walk_t   out_data_o
);

  ffgpu_texture_pkg::address_quad_t quad_q;
  ffgpu_texture_pkg::quad_levels_t  levels;
  logic [3:0]               left_q, others;  // lanes
  logic [4:0]               probe_q;
  logic                     coarse_q, last_level, last_probe, steps, start;
  logic [1:0]               lane;
  logic [95:0]              values;
  logic [2:0]               face;
  ffgpu_texture_pkg::texel_header_t header;

  assign in_ready_o  = left_q == 4'd0;
  assign start       = in_valid_i && in_ready_o;
  assign out_valid_o = left_q != 4'd0;
  assign steps       = out_valid_o && out_ready_i;

  always_comb begin
    lane = 2'd3;
    for (int i = 3; i >= 0; i--) begin
      if (left_q[i]) begin
        lane = i[1:0];
      end
    end
  end
  assign others     = left_q & ~(4'd1 << lane);
  assign levels     = quad_q.levels;
  assign last_level = coarse_q || levels.weight == 8'd0;
  assign last_probe = probe_q == levels.probes;
  assign values     = quad_q.coordinates[96*lane +: 96];
  assign face       = quad_q.faces[3*lane +: 3];

  assign header     = {levels.tag, levels.place, lane, face,
                       coarse_q ? levels.next_level : levels.level, levels.linear, last_level,
                       last_probe, levels.probes, probe_q, levels.weight};
  assign out_data_o = {header, values, levels.major_step};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      left_q <= 4'd0;
    end else if (start) begin
      left_q <= in_data_i.live;
    end else if (steps && last_level && last_probe) begin
      left_q <= others;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start) begin
      quad_q   <= in_data_i;
      probe_q  <= 5'd1;
      coarse_q <= 1'b0;
    end else if (steps) begin
      coarse_q <= !last_level;
      if (last_level) begin
        probe_q <= last_probe ? 5'd1 : probe_q + 5'd1;
      end
    end
  end

endmodule
