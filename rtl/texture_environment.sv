// The texture environment of one unit: a combiner for colour and one for alpha. As many of these
// follow each other as there are units; one that is off passes its quads on.
//
// Latency 3, one quad a cycle: arguments; exact results; scale, clamp and rounding. Equals
// ffgpu::combine() in model/fragment/texture_environment.cpp. The running colour enters as the
// primary one, so that it is Previous for the first unit as well.

module texture_environment (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_pkg::texture_environment_state_t state_0_i,
  input  ffgpu_pkg::texture_environment_state_t state_1_i,

  input  logic                                  in_valid_i,
  output logic                                  in_ready_o,
  input  ffgpu_pkg::shade_quad_t                in_data_i,

  output logic                                  out_valid_o,
  input  logic                                  out_ready_i,
  output ffgpu_pkg::shade_quad_t                out_data_o
);

  localparam int unsigned Units = ffgpu_pkg::TextureUnits;
  localparam int unsigned DoubledWidth = ffgpu_pkg::DoubledWidth;

  ffgpu_pkg::argument_quad_t argument_d, argument_q;
  ffgpu_pkg::doubled_quad_t  doubled_d, doubled_q;
  ffgpu_pkg::shade_quad_t    result_d;
  logic                      argument_valid, argument_ready, doubled_valid, doubled_ready;

  // Stage 1: arguments.
  ffgpu_pkg::texture_environment_state_t state_1;
  ffgpu_registers_pkg::combiner_t        combiner_1;
  ffgpu_pkg::quad_t                      quad_1;
  logic [23:0]                           rgb_selects, alpha_selects;  // operand, source; 0 lowest
  logic [4*4*4*8-1:0]                    arguments;

  assign quad_1     = in_data_i.quad;
  assign state_1    = quad_1.tag ? state_1_i : state_0_i;
  assign combiner_1 = ffgpu_registers_pkg::decode_combiner(state_1.combiner);
  assign rgb_selects = {combiner_1.rgb_operand_3, combiner_1.rgb_source_3,
                        combiner_1.rgb_operand_2, combiner_1.rgb_source_2,
                        combiner_1.rgb_operand_1, combiner_1.rgb_source_1,
                        combiner_1.rgb_operand_0, combiner_1.rgb_source_0};
  assign alpha_selects = {combiner_1.alpha_operand_3, combiner_1.alpha_source_3,
                          combiner_1.alpha_operand_2, combiner_1.alpha_source_2,
                          combiner_1.alpha_operand_1, combiner_1.alpha_source_1,
                          combiner_1.alpha_operand_0, combiner_1.alpha_source_0};

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_arguments
    logic [32*Units-1:0] samples;

    always_comb begin
      samples = '0;
      if (in_valid_i && in_ready_o) begin
        for (int unsigned unit = 0; unit < Units; unit++) begin
          samples[32*unit +: 32] = state_1.sampled_units[unit] ?
            in_data_i.samples[32*(4*unit+lane) +: 32] : 32'hff00_0000;
        end
      end
    end
    for (genvar slot = 0; slot < 16; slot++) begin : g_slot  // argument slot % 4 of a channel
      logic [5:0] selects;
      assign selects = slot / 4 == 3 ? alpha_selects[6*(slot%4) +: 6] :
        rgb_selects[6*(slot%4) +: 6];
      combine_argument #(
        .Channel(slot / 4)
      ) u_argument (
        .enable_i  (in_valid_i && in_ready_o),
        .source_i  (selects[3:0]),
        .operand_i (selects[5:4]),
        .constant_i(combiner_1.constant),
        .samples_i (samples),
        .primary_i (in_data_i.primary[32*lane +: 32]),
        .previous_i(quad_1.color[32*lane +: 32]),
        .value_o   (arguments[8*(16*lane+slot) +: 8])
      );
    end
  end

  assign argument_d = {in_data_i, arguments};

  pipeline_register #(
    .Width($bits(argument_d))
  ) u_argument (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i  (argument_d),
    .out_valid_o(argument_valid),
    .out_ready_i(argument_ready),
    .out_data_o (argument_q)
  );

  // Stage 2: the exact results.
  ffgpu_pkg::texture_environment_state_t state_2;
  ffgpu_registers_pkg::combiner_t        combiner_2;
  ffgpu_pkg::shade_quad_t                shaded_2;
  ffgpu_pkg::quad_t                      quad_2;
  logic                                  is_dot, is_dot_rgba;
  logic [16*DoubledWidth-1:0]            doubled;

  assign shaded_2    = argument_q.shaded;
  assign quad_2      = shaded_2.quad;
  assign state_2     = quad_2.tag ? state_1_i : state_0_i;
  assign combiner_2  = ffgpu_registers_pkg::decode_combiner(state_2.combiner);
  assign is_dot_rgba = combiner_2.rgb_op == ffgpu_registers_pkg::CombineOpDot3Rgba;
  assign is_dot = is_dot_rgba || combiner_2.rgb_op == ffgpu_registers_pkg::CombineOpDot3Rgb;

  for (genvar lane = 0; lane < ffgpu_pkg::Lanes; lane++) begin : g_operations
    logic [DoubledWidth-1:0] dot;

    combine_dot u_dot (
      .enable_i   (argument_valid && argument_ready && is_dot),
      .arguments_i(argument_q.arguments[128*lane +: 96]),
      .doubled_o  (dot)
    );
    for (genvar channel = 0; channel < 4; channel++) begin : g_channel
      localparam int unsigned At = 4 * lane + channel;
      logic [DoubledWidth-1:0] plain;

      combine_operation u_operation (
        .enable_i   (argument_valid && argument_ready),
        .operation_i(channel == 3 ? combiner_2.alpha_op : combiner_2.rgb_op),
        .arguments_i(argument_q.arguments[32*At +: 32]),
        .doubled_o  (plain)
      );
      assign doubled[DoubledWidth*At +: DoubledWidth] =
        (channel == 3 ? is_dot_rgba : is_dot) ? dot : plain;
    end
  end

  assign doubled_d = {shaded_2, doubled};

  pipeline_register #(
    .Width($bits(doubled_d))
  ) u_doubled (
    .clk_i,
    .rst_ni,
    .in_valid_i (argument_valid),
    .in_ready_o (argument_ready),
    .in_data_i  (doubled_d),
    .out_valid_o(doubled_valid),
    .out_ready_i(doubled_ready),
    .out_data_o (doubled_q)
  );

  // Stage 3: scale, clamp, rounding.
  ffgpu_pkg::texture_environment_state_t state_3;
  ffgpu_registers_pkg::combiner_t        combiner_3;
  ffgpu_pkg::shade_quad_t                shaded_3;
  ffgpu_pkg::quad_t                      quad_3, colored_3;
  logic [127:0]                          color;

  assign shaded_3    = doubled_q.shaded;
  assign quad_3      = shaded_3.quad;
  assign state_3     = quad_3.tag ? state_1_i : state_0_i;
  assign combiner_3  = ffgpu_registers_pkg::decode_combiner(state_3.combiner);

  for (genvar channel = 0; channel < 4 * ffgpu_pkg::Lanes; channel++) begin : g_finish
    combine_finish u_finish (
      .enable_i     (doubled_valid && doubled_ready),
      .doubled_i    (doubled_q.doubled[DoubledWidth*channel +: DoubledWidth]),
      .scale_shift_i(channel % 4 == 3 ? combiner_3.alpha_scale_shift : combiner_3.rgb_scale_shift),
      .result_o     (color[8*channel +: 8])
    );
  end

  always_comb begin
    colored_3 = quad_3;
    if (combiner_3.enable) begin
      colored_3.color = color;
    end
  end
  assign result_d = {colored_3, shaded_3.primary, shaded_3.secondary, shaded_3.fog_coordinate,
                     shaded_3.samples};

  pipeline_register #(
    .Width($bits(result_d))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (doubled_valid),
    .in_ready_o (doubled_ready),
    .in_data_i  (result_d),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
