// The mean of up to sixteen colours, to nearest: (sum + count / 2) / count in integers.
//
// Combinational. Equals the mean of probes in filter_fragment(), model/texture/sample.cpp. The
// quotient is a multiplication, exact for all sums that come up.

module filter_mean (
  input  logic                enable_i,  // low: nobody looks at the mean, which is 0
  input  logic [11:0]         sum_i,
  input  logic [4:0]          count_i,  // 1 .. 16
  output ffgpu_pkg::channel_t mean_o
);

  logic [16:0] inverse;  // 65536 / count, rounded up
  logic [29:0] biased, quotient;

  always_comb begin
    inverse  = 17'd0;
    biased   = 30'd0;
    quotient = 30'd0;
    if (enable_i) begin
      unique case (count_i)
        5'd2:    inverse = 17'd32768;
        5'd3:    inverse = 17'd21846;
        5'd4:    inverse = 17'd16384;
        5'd5:    inverse = 17'd13108;
        5'd6:    inverse = 17'd10923;
        5'd7:    inverse = 17'd9363;
        5'd8:    inverse = 17'd8192;
        5'd9:    inverse = 17'd7282;
        5'd10:   inverse = 17'd6554;
        5'd11:   inverse = 17'd5958;
        5'd12:   inverse = 17'd5462;
        5'd13:   inverse = 17'd5042;
        5'd14:   inverse = 17'd4682;
        5'd15:   inverse = 17'd4370;
        5'd16:   inverse = 17'd4096;
        default: inverse = 17'd65536;
      endcase
      biased   = {18'd0, sum_i} + {26'd0, count_i[4:1]};
      quotient = biased * {13'd0, inverse};
    end
  end
  assign mean_o = quotient[23:16];

endmodule
