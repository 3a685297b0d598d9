// quad_interlock in front of a read, six stages and a store, as a target has them, of which its table
// lets four quads in: each reads its place's number and stores one more. Left in depth 0 is how many of the place were
// before.

module interlock_loop (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  ffgpu_pkg::quad_t in_data_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output ffgpu_pkg::quad_t out_data_o
);

  localparam int unsigned Stages = 6;
  localparam int unsigned Width = $bits(in_data_i);

  ffgpu_pkg::quad_t        free, read;
  logic [(Stages+1)*Width-1:0] data;
  logic [Stages:0]         valid, ready;
  logic [256*24-1:0]       numbers_q;  // of 16x16 quads
  logic [7:0]              read_at, store_at;
  logic                    stores;

  quad_interlock #(
    .Entries(4)
  ) u_interlock (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o(valid[0]),
    .out_ready_i(ready[0]),
    .out_data_o (free),
    .release_i  (stores)
  );

  // The table holds the place of what entered last, as it is.
  logic        entered_q;
  logic [1:0]  entry_q;
  logic [23:0] place_q;

  always_ff @(posedge clk_i) begin
    entered_q <= rst_ni && u_interlock.enters;
    entry_q   <= u_interlock.last_q;
    place_q   <= {free.y[12:1], free.x[12:1]};
    if (entered_q && rst_ni) begin
      assert (u_interlock.places_q[24*entry_q +: 24] == place_q)
      else $error("%m: entry %0d: another quad's place", entry_q);
    end
  end

  assign read_at = {free.y[4:1], free.x[4:1]};
  always_comb begin
    read             = free;
    read.depth[23:0] = numbers_q[24*read_at +: 24];
  end
  assign data[Width-1:0] = read;

  for (genvar stage = 0; stage < Stages; stage++) begin : g_stage
    pipeline_register #(
      .Width(Width)
    ) u_stage (
      .clk_i,
      .rst_ni,
      .in_valid_i (valid[stage]),
      .in_ready_o (ready[stage]),
      .in_data_i  (data[Width*stage +: Width]),
      .out_valid_o(valid[stage+1]),
      .out_ready_i(ready[stage+1]),
      .out_data_o (data[Width*(stage+1) +: Width])
    );
  end

  assign out_valid_o   = valid[Stages];
  assign ready[Stages] = out_ready_i;
  assign out_data_o    = data[Width*Stages +: Width];
  assign stores        = out_valid_o && out_ready_i;
  assign store_at      = {out_data_o.y[4:1], out_data_o.x[4:1]};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      numbers_q <= '0;
    end else if (stores) begin
      numbers_q[24*store_at +: 24] <= out_data_o.depth[23:0] + 24'd1;
    end
  end

endmodule
