// A quad waits for its samples: a live lane after the other, a texture unit after the other.
//
// A sample a cycle; a quad of a draw that samples nothing passes in one.

module sample_collect (
  input  logic                          clk_i,

  // By the quad's tag.
  input  logic [7:0]                    sampled_units_0_i,
  input  logic [7:0]                    sampled_units_1_i,

  input  logic                          in_valid_i,
  output logic                          in_ready_o,
  input  ffgpu_pipe_pkg::pending_quad_t in_data_i,

  input  logic                          sample_valid_i,
  output logic                          sample_ready_o,
  input  ffgpu_pkg::texel_t             sample_i,  // place as texture_unit gives it

  output logic                          out_valid_o,
  input  logic                          out_ready_i,
  output ffgpu_pkg::shade_quad_t        out_data_o
);

  ffgpu_pkg::quad_t quad;
  logic [1023:0]    samples_q, samples;
  logic [4:0]       at;
  logic [3:0]       above;  // lanes behind the sample's
  logic             has_samples, is_last, takes;

  assign quad        = in_data_i.quad;
  assign has_samples = (quad.tag ? sampled_units_1_i : sampled_units_0_i) != 8'd0;
  assign at          = sample_i.place[4:0];
  assign above       = 4'b1110 << at[1:0];
  assign is_last     = sample_i.place[5] && (quad.live & above) == 4'd0;

  always_comb begin
    samples = samples_q;
    // Place by place: one in so wide a vector would be a shifter.
    if (has_samples && sample_valid_i) begin
      for (int unsigned i = 0; i < 32; i++) begin
        if (at == i[4:0]) begin
          samples[32*i +: 32] = sample_i.color;
        end
      end
    end
  end

  assign sample_ready_o = in_valid_i && has_samples && (!is_last || out_ready_i);
  assign out_valid_o    = in_valid_i && (!has_samples || (sample_valid_i && is_last));
  assign in_ready_o     = out_ready_i && (!has_samples || (sample_valid_i && is_last));
  assign takes          = sample_valid_i && sample_ready_o;
  assign out_data_o     = {in_data_i, samples};

  always_ff @(posedge clk_i) begin
    if (takes) begin
      samples_q <= samples;
    end
  end

endmodule
