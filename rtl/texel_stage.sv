// One step of a request from coordinates to texel coordinates: a texel_axis an axis, and their
// register.
//
// Latency 1, one request a cycle.

module texel_stage #(
  parameter int unsigned Stage = 0
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  input  ffgpu_pkg::texture_state_t state_0_i,
  input  ffgpu_pkg::texture_state_t state_1_i,

  input  logic                      in_valid_i,
  output logic                      in_ready_o,
  input  ffgpu_texture_pkg::texel_walk_t    in_data_i,

  output logic                      out_valid_o,
  input  logic                      out_ready_i,
  output ffgpu_texture_pkg::texel_walk_t    out_data_o
);

  localparam int unsigned RuleWidth = 79;
  localparam bit HasRule = Stage != 0 && Stage != 2;  // steps that are the same for all modes

  ffgpu_registers_pkg::texture_image_t image;
  ffgpu_registers_pkg::sampler_t       sampler;
  ffgpu_pkg::texture_state_t           state;
  ffgpu_texture_pkg::texel_header_t    header;
  ffgpu_texture_pkg::texel_walk_t      left;
  logic [95:0]                         values, others;

  assign header  = in_data_i.header;
  assign left    = {header, values, others};
  assign state   = header.tag ? state_1_i : state_0_i;
  assign image   = ffgpu_registers_pkg::decode_texture_image(state.image);
  assign sampler = ffgpu_registers_pkg::decode_sampler(state.sampler);

  for (genvar axis = 0; axis < 3; axis++) begin : g_axis
    logic [RuleWidth-1:0] rule;

    axis_rule #(
      .Axis(axis)
    ) u_rule (
      .enable_i (in_valid_i && in_ready_o && HasRule),
      .image_i  (image),
      .sampler_i(sampler),
      .header_i (header),
      .rule_o   (rule)
    );
    texel_axis #(
      .Stage(Stage),
      .Axis (axis)
    ) u_axis (
      .enable_i  (in_valid_i && in_ready_o),
      .operands_i({rule, in_data_i}),
      .value_o   (values[32*axis +: 32]),
      .other_o   (others[32*axis +: 32])
    );
  end

  pipeline_register #(
    .Width($bits(left))
  ) u_left (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(left),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
