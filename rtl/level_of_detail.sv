// The level of detail of a quad: from its texture coordinates the levels, the filter and the
// anisotropic probes that its fragments share.
//
// Latency 6, one quad a cycle: differences; texels; squares; sums in s and t; in r; choice. Equals
// ffgpu::sample_quad() in model/texture/level_of_detail.cpp, for images that are there.

module level_of_detail (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_pkg::texture_state_t state_0_i,
  input  ffgpu_pkg::texture_state_t state_1_i,

  input  logic                      in_valid_i,
  output logic                      in_ready_o,
  input  ffgpu_texture_pkg::level_quad_t    in_data_i,

  output logic                      out_valid_o,
  input  logic                      out_ready_i,
  output ffgpu_texture_pkg::quad_levels_t   out_data_o
);

  localparam int unsigned Stages = ffgpu_registers_pkg::LevelOfDetailLatency - 1;

  ffgpu_texture_pkg::level_steps_t     first, last;
  localparam int unsigned Width = $bits(first);
  logic [(Stages+1)*Width-1:0] data;
  logic [Stages:0]             valid, ready;

  // Lane 1 and lane 2 less lane 0 are to be made: the minuends first.
  assign first = {in_data_i.tag, in_data_i.place, in_data_i.one_face,
                  in_data_i.coordinates[95:0], in_data_i.coordinates[95:0],
                  in_data_i.coordinates[32*3 +: 2*96]};
  assign data[Width-1:0] = first;
  assign valid[0]        = in_valid_i;
  assign in_ready_o      = ready[0];

  for (genvar stage = 0; stage < Stages; stage++) begin : g_stage
    level_stage #(
      .Stage(stage)
    ) u_stage (
      .clk_i,
      .rst_ni,
      .state_0_i,
      .state_1_i,
      .in_valid_i (valid[stage]),
      .in_ready_o (ready[stage]),
      .in_data_i  (data[Width*stage +: Width]),
      .out_valid_o(valid[stage+1]),
      .out_ready_i(ready[stage+1]),
      .out_data_o (data[Width*(stage+1) +: Width])
    );
  end

  // The choice.
  ffgpu_pkg::texture_state_t           state;
  ffgpu_registers_pkg::texture_image_t image;
  ffgpu_registers_pkg::sampler_t       sampler;
  ffgpu_texture_pkg::quad_levels_t             levels;
  ffgpu_pkg::float_t                   x_square, y_square;
  logic [17:0]                         x_logarithm, y_logarithm, lambda;
  logic [4:0]                          probes;
  logic [3:0]                          level, next_level;
  logic [7:0]                          weight;
  logic                                linear;
  logic [95:0]                         major_step;

  assign last     = data[Width*Stages +: Width];
  assign state    = last.tag ? state_1_i : state_0_i;
  assign image    = ffgpu_registers_pkg::decode_texture_image(state.image);
  assign sampler  = ffgpu_registers_pkg::decode_sampler(state.sampler);
  assign x_square = last.values[31:0];
  assign y_square = last.values[32*3 +: 32];

  level_logarithm u_x_logarithm (
    .value_i    (x_square),
    .logarithm_o(x_logarithm)
  );
  level_logarithm u_y_logarithm (
    .value_i    (y_square),
    .logarithm_o(y_logarithm)
  );
  level_probes u_probes (
    .enable_i     (valid[Stages] && ready[Stages]),
    .sampler_i    (sampler),
    .one_face_i   (last.one_face),
    .x_logarithm_i(x_logarithm),
    .y_logarithm_i(y_logarithm),
    .probes_o     (probes),
    .lambda_o     (lambda)
  );
  level_choice u_choice (
    .image_i     (image),
    .sampler_i   (sampler),
    .lambda_i    (lambda),
    .level_o     (level),
    .next_level_o(next_level),
    .weight_o    (weight),
    .linear_o    (linear)
  );

  // Squares are positive: their bits compare as integers.
  assign major_step = x_square >= y_square ? last.steps[95:0] : last.steps[191:96];
  assign levels     = {last.tag, last.place, level, next_level, weight, linear, probes, major_step};

  pipeline_register #(
    .Width($bits(levels))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (valid[Stages]),
    .in_ready_o (ready[Stages]),
    .in_data_i  (levels),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
