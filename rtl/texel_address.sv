// Where a quad's texels are: for each live fragment, each probe and each level the coordinates of
// up to eight texels in the stored image, and the weights of the filter.
//
// Latency 9; a request a cycle, one between quads. Equals what sample_scalar() in
// model/texture/sample.cpp tells of its accesses.

module texel_address (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_pkg::texture_state_t state_0_i,
  input  ffgpu_pkg::texture_state_t state_1_i,

  input  logic                      in_valid_i,
  output logic                      in_ready_o,
  input  ffgpu_texture_pkg::address_quad_t  in_data_i,

  output logic                      out_valid_o,
  input  logic                      out_ready_i,
  output ffgpu_texture_pkg::texel_request_t out_data_o
);

  localparam int unsigned Stages = ffgpu_registers_pkg::TexelAddressLatency - 2;

  ffgpu_texture_pkg::texel_walk_t      last;
  localparam int unsigned Width = $bits(last);
  logic [(Stages+1)*Width-1:0] data;
  logic [Stages:0]             valid, ready;

  texel_sequence u_sequence (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o(valid[0]),
    .out_ready_i(ready[0]),
    .out_data_o (data[Width-1:0])
  );

  for (genvar stage = 0; stage < Stages; stage++) begin : g_stage
    texel_stage #(
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

  // Texels.
  ffgpu_pkg::texture_state_t           state;
  ffgpu_registers_pkg::texture_image_t image;
  ffgpu_texture_pkg::texel_header_t            header;
  ffgpu_texture_pkg::texel_request_t           request;
  logic [2:0]                          is_used;
  logic [3*13-1:0]                     sizes;
  logic [3*28-1:0]                     pairs;
  logic [23:0]                         weights;
  logic [27:0]                         faces;

  assign last    = data[Width*Stages +: Width];
  assign header  = last.header;
  assign state   = header.tag ? state_1_i : state_0_i;
  assign image   = ffgpu_registers_pkg::decode_texture_image(state.image);
  assign is_used = {image.kind == ffgpu_registers_pkg::TextureKindThreeD,
                    image.kind != ffgpu_registers_pkg::TextureKindOneD, 1'b1};
  assign sizes   = {3'd0, image.depth, image.height, image.width};

  for (genvar axis = 0; axis < 3; axis++) begin : g_axis
    logic [12:0] shifted, size;

    assign shifted = sizes[13*axis +: 13] >> header.level;
    assign size    = shifted == 13'd0 ? 13'd1 : shifted;
    texel_pair u_pair (
      .enable_i       (valid[Stages] && ready[Stages]),
      .is_used_i      (is_used[axis]),
      .linear_i       (header.linear),
      .wraps_i        (last.others[32*axis + 1]),
      .border_i       (last.others[32*axis]),
      .stored_border_i(image.border),
      .size_i         (size),
      .coordinate_i   (last.values[32*axis +: 24]),
      .first_o        (pairs[28*axis +: 14]),
      .second_o       (pairs[28*axis + 14 +: 14]),
      .weight_o       (weights[8*axis +: 8])
    );
  end

  // The face of a cube map, where the filter has no third axis.
  assign faces   = {11'd0, header.face, 11'd0, header.face};
  assign request = {header, weights[23:16], weights[15:8], weights[7:0],
                    is_used[2] ? pairs[83:56] : faces, pairs[55:0]};

  pipeline_register #(
    .Width($bits(request))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (valid[Stages]),
    .in_ready_o (ready[Stages]),
    .in_data_i  (request),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
