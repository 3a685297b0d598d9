// A primitive is given no slot of another one that is still walked, or of which a quad has not been
// interpolated; and where all are free it is given one.
// For 11 cycles.
// Refused with: record_store: !is_walked -> 1'b1
// Refused with: record_store: counts_q[CountWidth*oldest +: CountWidth] == '0 -> 1'b1
// Refused with: record_store: oldest_q != {~fill_q[SlotWidth], fill} -> 1'b1
// Refused with: record_store: CountWidth] - 8'd1 -> CountWidth] - 8'd0

module record_store_proof (
  input logic       clk_i,
  input logic       rst_ni,
  input logic       taken_i,  // a record, where none is walked
  input logic       ends_i,   // the walk
  input logic       found_i,
  input logic       done_i,
  input logic [1:0] done_slot_i
);

  logic        begun_q = 1'b0;  // There has been a reset.
  logic        ready, takes, found, done, walking_q, was_free_q;
  logic [1:0]  slot, walked_q;
  logic [15:0] quads_q, quads;  // of each slot, found and not done

  assign takes = taken_i && ready && !walking_q;
  assign found = found_i && walking_q;
  assign done  = done_i && quads_q[4*done_slot_i +: 4] != 4'd0;

  record_store u_store (
    .clk_i,
    .rst_ni,
    .plane_valid_i     (1'b0),
    .plane_ready_o     (),
    .plane_i           ('0),
    .record_taken_i    (takes),
    .header_i          ('0),
    .record_ready_o    (ready),
    .record_slot_o     (slot),
    .walking_i         (walking_q),
    .walked_slot_i     (walked_q),
    .found_i           (found),
    .done_i            (done),
    .done_slot_i,
    .headers_o         (),
    .q_scales_o        (),
    .first_slot_i      ('0),
    .first_attribute_i ('0),
    .first_plane_o     (),
    .second_slot_i     ('0),
    .second_attribute_i('0),
    .second_plane_o    ()
  );

  always_comb begin
    quads = quads_q;
    if (found) begin
      quads[4*walked_q +: 4] = quads[4*walked_q +: 4] + 4'd1;
    end
    if (done) begin
      quads[4*done_slot_i +: 4] = quads[4*done_slot_i +: 4] - 4'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    begun_q <= 1'b1;
    if (!rst_ni) begin
      walking_q  <= 1'b0;
      quads_q    <= 16'd0;
      was_free_q <= 1'b0;
    end else begin
      walking_q  <= takes || (walking_q && !ends_i);
      quads_q    <= quads;
      was_free_q <= !walking_q && quads_q == 16'd0;
      if (takes) begin
        walked_q <= slot;
      end
    end
  end

  always_comb begin
    assume (begun_q || !rst_ni);
    if (begun_q && rst_ni) begin
      assert (!takes || quads_q[4*slot +: 4] == 4'd0);
      assert (!was_free_q || ready);
    end
  end

endmodule
