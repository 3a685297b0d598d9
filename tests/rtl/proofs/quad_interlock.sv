// No quad leaves the interlock while one of its place is behind it, whatever enters and whenever
// stores are done; nor more of them than it has entries.
// For 10 cycles.
// Refused with: quad_interlock: meets == '0 && -> 1'b1 &&
// Refused with: quad_interlock: && !used_q[last_q] -> && 1'b1
// Refused with: quad_interlock: PlaceWidth] <= place -> PlaceWidth] <= {place[23:1], 1'b0}

module quad_interlock_proof (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             in_valid_i,
  input ffgpu_pkg::quad_t in_data_i,
  input logic             out_ready_i,
  input logic             release_i
);

  ffgpu_pkg::quad_t out;
  logic             in_ready, out_valid, leaves;
  logic             begun_q = 1'b0;  // There has been a reset.
  logic [1:0]       behind_q, kept;  // quads, before and after the oldest's end
  logic [23:0]      place, oldest_q, newest_q;

  quad_interlock #(
    .Entries(2)
  ) u_interlock (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o (in_ready),
    .in_data_i,
    .out_valid_o(out_valid),
    .out_ready_i,
    .out_data_o (out),
    .release_i
  );

  assign place  = {out.y[12:1], out.x[12:1]};
  assign leaves = out_valid && out_ready_i;
  assign kept   = behind_q - {1'b0, release_i};

  always_ff @(posedge clk_i) begin
    begun_q <= 1'b1;
    if (!rst_ni) begin
      behind_q <= 2'd0;
    end else begin
      behind_q <= kept + {1'b0, leaves};
      if (release_i) begin
        oldest_q <= newest_q;
      end
      if (leaves) begin
        newest_q <= place;
        if (kept == 2'd0) begin
          oldest_q <= place;
        end
      end
    end
  end

  always_comb begin
    assume (begun_q || !rst_ni);
    assume (!release_i || behind_q != 2'd0);
    if (begun_q && rst_ni && out_valid) begin
      assert (behind_q < 2'd2);
      assert (behind_q == 2'd0 || place != newest_q);
      assert (behind_q < 2'd2 || place != oldest_q);
    end
  end

endmodule
