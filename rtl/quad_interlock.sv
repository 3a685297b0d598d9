// The gate in front of a target's read: a quad waits while one of its place is between read and
// store.
//
// Latency 1, one quad a cycle where places differ. Quads leave in the order in which they came, and
// their stores are done in it: release_i takes the oldest out of the table. docs/rtl.md says why.
// Entries is a power of two.

module quad_interlock #(
  parameter int unsigned Entries = 8
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  ffgpu_pkg::quad_t in_data_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output ffgpu_pkg::quad_t out_data_o,

  input  logic             release_i
);

  localparam int unsigned PlaceWidth = 24;  // of quads, which begin at even pixels
  localparam int unsigned IndexWidth = $clog2(Entries);

  ffgpu_pkg::quad_t              quad;
  logic                          quad_valid, quad_ready, enters, is_free;
  logic [PlaceWidth-1:0]         place;
  logic [Entries*PlaceWidth-1:0] places_q;
  logic [Entries-1:0]            used_q, meets;
  logic [IndexWidth-1:0]         first_q, last_q;  // oldest; where the next one goes

  pipeline_register #(
    .Width($bits(quad))
  ) u_in (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o(quad_valid),
    .out_ready_i(quad_ready),
    .out_data_o (quad)
  );

  assign place = {quad.y[12:1], quad.x[12:1]};
  for (genvar i = 0; i < Entries; i++) begin : g_entry
    assign meets[i] = used_q[i] && places_q[PlaceWidth*i +: PlaceWidth] == place;
  end

  // Quads enter when they leave here, so that what is free once stays free until then.
  assign is_free     = meets == '0 && !used_q[last_q];
  assign out_valid_o = quad_valid && is_free;
  assign quad_ready  = out_ready_i && is_free;
  assign out_data_o  = quad;
  assign enters      = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      used_q  <= '0;
      first_q <= '0;
      last_q  <= '0;
    end else begin
      if (enters) begin
        used_q[last_q] <= 1'b1;
        last_q         <= last_q + 1'b1;
      end
      if (release_i) begin
        used_q[first_q] <= 1'b0;
        first_q         <= first_q + 1'b1;
      end
    end
  end
  // Entry by entry: a place in so wide a vector would be a shifter.
  always_ff @(posedge clk_i) begin
    for (int unsigned i = 0; i < Entries; i++) begin
      if (enters && last_q == i[IndexWidth-1:0]) begin
        places_q[PlaceWidth*i +: PlaceWidth] <= place;
      end
    end
  end

endmodule
