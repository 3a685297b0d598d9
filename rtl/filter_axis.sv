// One level of the tree: lerps along an axis, from 2 Pairs texels to as many as there are pairs.
//
// Latency 1, one item a cycle. The results stand in the lower texels.

module filter_axis #(
  parameter int unsigned Pairs = 4
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     in_valid_i,
  output logic                     in_ready_o,
  input  ffgpu_pkg::filter_level_t in_data_i,

  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output ffgpu_pkg::filter_level_t out_data_o
);

  ffgpu_pkg::filter_level_t filtered;
  ffgpu_pkg::weight_t       weight;
  logic [32*Pairs-1:0]      colors;

  assign weight = Pairs == 4 ? in_data_i.weight_x : Pairs == 2 ? in_data_i.weight_y :
    in_data_i.weight_z;

  for (genvar pair = 0; pair < Pairs; pair++) begin : g_pair
    texture_lerp u_lerp (
      .enable_i(in_valid_i && in_ready_o),
      .a_i     (in_data_i.texels[64*pair +: 32]),
      .b_i     (in_data_i.texels[64*pair+32 +: 32]),
      .weight_i(weight),
      .value_o (colors[32*pair +: 32])
    );
  end

  always_comb begin
    filtered        = in_data_i;
    filtered.texels = 256'(colors);
  end

  pipeline_register #(
    .Width($bits(filtered))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(filtered),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
