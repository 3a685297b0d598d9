// Which levels a quad is sampled from, and how: of lambda, the biased and clamped level of detail.
//
// Combinational. Equals ffgpu::choose_levels() in model/texture/level_of_detail.cpp.

module level_choice (
  input  ffgpu_registers_pkg::texture_image_t image_i,
  input  ffgpu_registers_pkg::sampler_t       sampler_i,
  input  logic [17:0]                         lambda_i,  // signed, 8 fraction bits
  output logic [3:0]                          level_o,
  output logic [3:0]                          next_level_o,
  output logic [7:0]                          weight_o,
  output logic                                linear_o
);

  localparam logic [3:0] MostLevels = 4'd13;

  logic [3:0]  levels, last, down, nearest, finer;
  logic [17:0] limit, rounded;
  logic        halves, magnifies;

  assign levels = image_i.levels > MostLevels ? MostLevels : image_i.levels;
  assign last   = sampler_i.max_level > levels - 4'd1 ? levels - 4'd1 : sampler_i.max_level;

  // The switch lies at 1/2 where a linear filter magnifies and the nearest texel minifies.
  assign halves    = sampler_i.magnify_linear && !sampler_i.minify_linear &&
    sampler_i.mip_filter != ffgpu_registers_pkg::MipFilterNone;
  assign limit     = halves ? 18'd128 : 18'd0;
  assign magnifies = lambda_i[17] || lambda_i <= limit;

  // Minified, lambda is positive. ceil(lambda + 1/2) - 1: halves go to the finer level.
  assign rounded = lambda_i + 18'd127;
  assign nearest = rounded[17:8] > {6'd0, last} ? last : rounded[11:8];
  assign down    = lambda_i[17:8] > {6'd0, last} ? last : lambda_i[11:8];
  assign finer   = down + 4'd1 > last ? last : down + 4'd1;

  always_comb begin
    level_o      = 4'd0;
    next_level_o = 4'd0;
    weight_o     = 8'd0;
    linear_o     = magnifies ? sampler_i.magnify_linear : sampler_i.minify_linear;
    if (!magnifies && sampler_i.mip_filter == ffgpu_registers_pkg::MipFilterNearest) begin
      level_o = nearest;
    end
    if (!magnifies && sampler_i.mip_filter >= ffgpu_registers_pkg::MipFilterLinear) begin
      level_o      = down;
      next_level_o = finer;
      weight_o     = last > down ? lambda_i[7:0] : 8'd0;
    end
  end

endmodule
