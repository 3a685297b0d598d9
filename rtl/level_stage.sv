// One step of a quad to the squared sides of its pixel: what each element becomes, and the register.
//
// Latency 1, one quad a cycle. Element 3 side + axis: sides x and y, axes s, t and r.

module level_stage #(
  parameter int unsigned Stage = 0
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  input  ffgpu_pkg::texture_state_t state_0_i,
  input  ffgpu_pkg::texture_state_t state_1_i,

  input  logic                      in_valid_i,
  output logic                      in_ready_o,
  input  ffgpu_texture_pkg::level_steps_t   in_data_i,

  output logic                      out_valid_o,
  input  logic                      out_ready_i,
  output ffgpu_texture_pkg::level_steps_t   out_data_o
);

  ffgpu_pkg::texture_state_t           state;
  ffgpu_texture_pkg::level_steps_t             left;
  ffgpu_registers_pkg::texture_image_t image;
  logic [1:0]                          is_used;
  logic [38:0]                         densities;
  logic [191:0]                        values;

  assign state = in_data_i.tag ? state_1_i : state_0_i;
  assign image = ffgpu_registers_pkg::decode_texture_image(state.image);

  // Coordinates of rectangles count texels.
  always_comb begin
    densities = '0;
    if (in_valid_i && in_ready_o) begin
      densities = {3'd0, image.depth, image.height, image.width};
      if (image.kind == ffgpu_registers_pkg::TextureKindRectangle) begin
        densities[25:0] = {13'd1, 13'd1};
      end
    end
  end
  assign is_used = {image.kind == ffgpu_registers_pkg::TextureKindThreeD,
                    image.kind != ffgpu_registers_pkg::TextureKindOneD};

  for (genvar element = 0; element < 6; element++) begin : g_element
    level_step #(
      .Stage  (Stage),
      .Element(element)
    ) u_step (
      .enable_i  (in_valid_i && in_ready_o),
      .operands_i({is_used, densities, in_data_i}),
      .value_o   (values[32*element +: 32])
    );
  end

  // Of the first step the differences are kept.
  always_comb begin
    left        = in_data_i;
    left.values = values;
    if (Stage == 0) begin
      left.steps = values;
    end
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
