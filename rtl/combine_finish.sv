// Scales a combiner's exact result by 1, 2 or 4, clamps it to [0, 1] and rounds it to 8 bits, to
// nearest, ties up.
//
// Combinational. Equals finish() in model/fragment/texture_environment.cpp.

module combine_finish (
  input  logic                               enable_i,  // low: nobody looks at the result
  input  logic [ffgpu_pkg::DoubledWidth-1:0] doubled_i,
  input  logic [1:0]                         scale_shift_i,
  output ffgpu_pkg::channel_t                result_o
);

  localparam logic [21:0] Most = 22'd130050;  // twice 1, in units of 1 / 65025

  logic [21:0] scaled, clamped, biased;

  always_comb begin
    scaled   = 22'd0;
    clamped  = 22'd0;
    biased   = 22'd0;
    if (enable_i) begin
      unique case (scale_shift_i)
        2'd0:    scaled = {2'd0, doubled_i};
        2'd1:    scaled = {1'b0, doubled_i, 1'b0};
        default: scaled = {doubled_i, 2'd0};
      endcase
      clamped = scaled > Most ? Most : scaled;
      if (doubled_i[ffgpu_pkg::DoubledWidth-1]) begin
        clamped = 22'd0;
      end

      // (clamped + 255) / 510 is half of it, rounded down, over 255.
      biased = clamped + 22'd255;
    end
    result_o = ffgpu_pkg::floor_255(biased[16:1]);
  end

endmodule
