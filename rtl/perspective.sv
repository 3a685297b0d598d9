// An attribute at the four fragments of a quad: the plane's integers times w, or 1/q, times the
// primitive's power of two; colours as 0 .. 255, fog coordinates in fog's range. It also makes the
// numbers whose reciprocals are w and 1/q.
//
// Latency 4, one attribute of a quad a cycle: binary32; product; scale and range; colours. Equals
// the _scalar functions of model/raster/interpolator.cpp, with attribute_plane before it, and
// reciprocal between the numbers to divide by and what is divided.

module perspective (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         in_valid_i,
  output logic                         in_ready_o,
  input  ffgpu_pkg::perspective_quad_t in_data_i,

  output logic                         out_valid_o,
  input  logic                         out_ready_i,
  output ffgpu_pkg::lane_values_t      out_data_o
);

  localparam int unsigned Stages = ffgpu_registers_pkg::PerspectiveLatency;

  ffgpu_pkg::perspective_quad_t last;
  localparam int unsigned Width = $bits(last);
  logic [(Stages+1)*Width-1:0]  data;
  logic [Stages:0]              valid, ready;

  assign data[Width-1:0] = in_data_i;
  assign valid[0]        = in_valid_i;
  assign in_ready_o      = ready[0];

  for (genvar stage = 0; stage < Stages; stage++) begin : g_stage
    perspective_stage #(
      .Stage(stage)
    ) u_stage (
      .clk_i,
      .rst_ni,
      .in_valid_i (valid[stage]),
      .in_ready_o (ready[stage]),
      .in_data_i  (data[Width*stage +: Width]),
      .out_valid_o(valid[stage+1]),
      .out_ready_i(ready[stage+1]),
      .out_data_o (data[Width*(stage+1) +: Width])
    );
  end

  assign last          = data[Width*Stages +: Width];
  assign out_valid_o   = valid[Stages];
  assign ready[Stages] = out_ready_i;
  assign out_data_o    = {last.tag, last.place, last.values};

endmodule
