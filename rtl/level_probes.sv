// Anisotropic probes of a quad and its level of detail, from the logarithms of its pixel's two
// squared sides in texels.
//
// Combinational. Equals count_probes() and level_of_detail() in model/texture/level_of_detail.cpp.

module level_probes (
  input  logic                          enable_i,  // low: nobody looks at what comes out
  input  ffgpu_registers_pkg::sampler_t sampler_i,
  input  logic                          one_face_i,
  input  logic [17:0]                   x_logarithm_i,  // signed, as y and lambda
  input  logic [17:0]                   y_logarithm_i,
  output logic [4:0]                    probes_o,
  output logic [17:0]                   lambda_o
);

  // 512 log2(n), rounded down, n = 1 lowest.
  localparam logic [16*12-1:0] ProbeLogarithms = {
    12'd2048, 12'd2000, 12'd1949, 12'd1894, 12'd1835, 12'd1771, 12'd1700, 12'd1623,
    12'd1536, 12'd1437, 12'd1323, 12'd1188, 12'd1024, 12'd811, 12'd512, 12'd0
  };

  logic        x_is_longer;
  logic [17:0] longer, shorter, ratio, square, half, biased, at_least;
  logic [4:0]  probes;
  logic [11:0] taken;

  // Signed numbers compare as unsigned ones when their signs are turned.
  assign x_is_longer = {~x_logarithm_i[17], x_logarithm_i[16:0]} >
    {~y_logarithm_i[17], y_logarithm_i[16:0]};
  assign longer  = x_is_longer ? x_logarithm_i : y_logarithm_i;
  assign shorter = x_is_longer ? y_logarithm_i : x_logarithm_i;
  assign ratio   = longer - (shorter[17] ? 18'd0 : shorter);

  always_comb begin
    probes = 5'd1;
    taken  = 12'd0;
    if (enable_i && sampler_i.minify_linear && one_face_i) begin
      for (int unsigned n = 1; n < 16; n++) begin
        if (n[4:0] < sampler_i.max_anisotropy && !ratio[17] &&
            ratio[16:0] > {5'd0, ProbeLogarithms[12*(n-1) +: 12]}) begin
          probes = n[4:0] + 5'd1;
        end
      end
      for (int unsigned n = 1; n <= 16; n++) begin
        if (n[4:0] == probes) begin
          taken = ProbeLogarithms[12*(n-1) +: 12];
        end
      end
    end
  end
  assign probes_o = probes;

  // Half of the square's logarithm, rounded down.
  assign square = longer - {6'd0, taken};
  assign half   = {square[17], square[17:1]};
  assign biased = half + {{2{sampler_i.bias[15]}}, sampler_i.bias};

  function automatic logic is_less(
    input logic [17:0] a,
    input logic [17:0] b
  );
    is_less = {~a[17], a[16:0]} < {~b[17], b[16:0]};
  endfunction

  logic [17:0] least, greatest;
  assign least    = {{2{sampler_i.min_lod[15]}}, sampler_i.min_lod};
  assign greatest = {{2{sampler_i.max_lod[15]}}, sampler_i.max_lod};
  assign at_least = is_less(biased, least) ? least : biased;
  assign lambda_o = is_less(greatest, at_least) ? greatest : at_least;

endmodule
