// Decoded texels into the level that their request's filter works on.
//
// A texel a cycle; a level leaves with its last texel.

module texel_gather (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         in_valid_i,
  output logic                         in_ready_o,
  input  ffgpu_pkg::texel_t            in_data_i,

  // Of the requests, in their order.
  input  logic                         filter_valid_i,
  output logic                         filter_ready_o,
  input  ffgpu_pipe_pkg::filter_note_t filter_i,

  output logic                         out_valid_o,
  input  logic                         out_ready_i,
  output ffgpu_pkg::filter_level_t     out_data_o
);

  logic [255:0] texels_q, texels;
  logic [2:0]   texel_q;
  logic         is_last, takes;

  assign is_last        = texel_q == filter_i.last_texel;
  assign in_ready_o     = filter_valid_i && (!is_last || out_ready_i);
  assign takes          = in_valid_i && in_ready_o;
  assign out_valid_o    = in_valid_i && filter_valid_i && is_last;
  assign filter_ready_o = in_valid_i && is_last && out_ready_i;

  always_comb begin
    texels = texels_q;
    if (in_valid_i) begin
      for (int unsigned i = 0; i < 8; i++) begin
        if (texel_q == i[2:0]) begin
          texels[32*i +: 32] = in_data_i.color;
        end
      end
    end
  end
  assign out_data_o = {filter_i.tag, filter_i.place, filter_i.last_level, filter_i.last_probe,
                       filter_i.probes, filter_i.weights, texels};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      texel_q <= 3'd0;
    end else if (takes) begin
      texel_q <= is_last ? 3'd0 : texel_q + 3'd1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (takes) begin
      texels_q <= texels;
    end
  end

endmodule
