// Fog: the colour fades into the fog's with the fog coordinate.
//
// Latency 6, one quad a cycle: five stages of fog_lane for the factor, one for the colour. Equals
// ffgpu::fog_factor() and apply_fog() in model/fragment/fog.cpp. The curve's coefficients are
// compile_fog()'s, made once a draw.

module fog (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // By the quad's tag; changes only while no quad of the tag is inside.
  input  ffgpu_pkg::fog_curve_t  state_0_i,
  input  ffgpu_pkg::fog_curve_t  state_1_i,

  input  logic                   in_valid_i,
  output logic                   in_ready_o,
  input  ffgpu_pkg::shade_quad_t in_data_i,

  output logic                   out_valid_o,
  input  logic                   out_ready_i,
  output ffgpu_pkg::quad_t       out_data_o
);

  localparam int unsigned Lanes = ffgpu_pkg::Lanes;
  localparam int unsigned FactorStages = ffgpu_registers_pkg::FogLatency - 1;

  // Number i enters stage i; those behind the last one enter the colour's.
  ffgpu_pkg::fog_quad_t              first, last;
  localparam int unsigned Width = $bits(first);
  logic [(FactorStages+1)*Width-1:0] data;
  logic [FactorStages:0]             valid, ready;

  assign first           = {in_data_i.quad, in_data_i.fog_coordinate};
  assign data[Width-1:0] = first;
  assign valid[0]        = in_valid_i;
  assign in_ready_o      = ready[0];

  for (genvar stage = 0; stage < FactorStages; stage++) begin : g_stage
    fog_stage #(
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

  // The colour: f c + (255 - f) fog colour over 255; alpha stays.
  ffgpu_pkg::quad_t      quad, faded;
  ffgpu_pkg::fog_curve_t curve;
  logic                  fades;
  logic [Lanes*32-1:0]   color;

  assign last  = data[Width*FactorStages +: Width];
  assign quad  = last.quad;
  assign curve = quad.tag ? state_1_i : state_0_i;

  assign fades = valid[FactorStages] && ready[FactorStages] &&
    curve.mode != ffgpu_registers_pkg::FogModeOff;

  always_comb begin
    color = quad.color;
    if (fades) begin
      for (int unsigned lane = 0; lane < Lanes; lane++) begin
        for (int unsigned channel = 0; channel < 3; channel++) begin
          color[32*lane+8*channel +: 8] = ffgpu_pkg::divide_255(
            {8'd0, last.values[32*lane +: 8]} * {8'd0, quad.color[32*lane+8*channel +: 8]} +
            {8'd0, ~last.values[32*lane +: 8]} * {8'd0, curve.color[8*channel +: 8]});
        end
      end
    end
    faded       = quad;
    faded.color = color;
  end

  pipeline_register #(
    .Width($bits(faded))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (valid[FactorStages]),
    .in_ready_o (ready[FactorStages]),
    .in_data_i  (faded),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
