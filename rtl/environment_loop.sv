// The texture environments of a draw, one after the other in one texture_environment: a quad goes
// round once for each combiner that is on.
//
// Four cycles a round, and one for the quad.

module environment_loop (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // By the quad's tag: words of the combiners, unit 0 lowest; changes only while no quad of the tag
  // is inside.
  input  logic [8*96-1:0]        combiners_0_i,
  input  logic [8*96-1:0]        combiners_1_i,
  input  logic [7:0]             sampled_units_0_i,
  input  logic [7:0]             sampled_units_1_i,

  input  logic                   in_valid_i,
  output logic                   in_ready_o,
  input  ffgpu_pkg::shade_quad_t in_data_i,

  output logic                   out_valid_o,
  input  logic                   out_ready_i,
  output ffgpu_pkg::shade_quad_t out_data_o
);

  ffgpu_pkg::shade_quad_t                shaded_q, result;
  ffgpu_pkg::quad_t                      entering, quad, result_quad;
  ffgpu_pkg::texture_environment_state_t state;
  ffgpu_registers_pkg::combiner_t        combiner;
  logic [8*96-1:0]                       entering_combiners, combiners;
  logic [95:0]                           combiner_words;
  logic [7:0]                            enabled, left_q;
  logic [2:0]                            unit;
  logic                                  has_quad_q, inside_q, enters, goes, goes_ready, returns;

  assign entering           = in_data_i.quad;
  assign entering_combiners = entering.tag ? combiners_1_i : combiners_0_i;
  always_comb begin
    for (int unsigned i = 0; i < 8; i++) begin
      combiner   = ffgpu_registers_pkg::decode_combiner(entering_combiners[96*i +: 96]);
      enabled[i] = combiner.enable;
    end
  end

  assign quad      = shaded_q.quad;
  assign combiners = quad.tag ? combiners_1_i : combiners_0_i;
  always_comb begin
    unit = 3'd7;
    for (int i = 6; i >= 0; i--) begin
      if (left_q[i]) begin
        unit = i[2:0];
      end
    end
  end
  // Unit by unit: a place in so wide a vector would be a shifter.
  always_comb begin
    combiner_words = '0;
    for (int unsigned i = 0; i < 8; i++) begin
      if (unit == i[2:0]) begin
        combiner_words = combiners[96*i +: 96];
      end
    end
  end
  assign state = {combiner_words, quad.tag ? sampled_units_1_i : sampled_units_0_i};

  assign goes        = has_quad_q && !inside_q && left_q != 8'd0;
  assign out_valid_o = has_quad_q && !inside_q && left_q == 8'd0;
  assign out_data_o  = shaded_q;
  assign in_ready_o  = !has_quad_q || (!inside_q && left_q == 8'd0 && out_ready_i);
  assign enters      = in_valid_i && in_ready_o;

  // One quad is inside, under one combiner.
  texture_environment u_environment (
    .clk_i,
    .rst_ni,
    .state_0_i  (state),
    .state_1_i  (state),
    .in_valid_i (goes),
    .in_ready_o (goes_ready),
    .in_data_i  (shaded_q),
    .out_valid_o(returns),
    .out_ready_i(1'b1),
    .out_data_o (result)
  );
  assign result_quad = result.quad;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      has_quad_q <= 1'b0;
      inside_q   <= 1'b0;
    end else begin
      if (enters) begin
        has_quad_q <= 1'b1;
      end else if (out_valid_o && out_ready_i) begin
        has_quad_q <= 1'b0;
      end
      inside_q <= (inside_q && !returns) || (goes && goes_ready);
    end
  end
  always_ff @(posedge clk_i) begin
    if (enters) begin
      // The running colour is the primary one at first.
      shaded_q            <= in_data_i;
      shaded_q.quad.color <= in_data_i.primary;
      left_q              <= enabled;
    end else if (returns) begin
      shaded_q.quad.color <= result_quad.color;
      left_q              <= left_q & (left_q - 8'd1);
    end
  end

endmodule
