// out = (a * (256 - weight) + b * weight + 128) >> 8: one lerp of the bilinear and trilinear filter.
//
// Latency 2, one result a cycle. Equals ffgpu::lerp8w() in model/texture/filter.h for every input.

module texture_lerp
  import ffgpu_pkg::*;
(
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     in_valid_i,
  output logic     in_ready_o,
  input  channel_t in_a_i,
  input  channel_t in_b_i,
  input  weight_t  in_weight_i,

  output logic     out_valid_o,
  input  logic     out_ready_i,
  output channel_t out_value_o
);

  localparam int unsigned SumWidth = 2 * ChannelWidth;
  localparam int unsigned ComplementWidth = ChannelWidth + 1;

  typedef logic [SumWidth-1:0] sum_t;
  typedef logic [ComplementWidth-1:0] complement_t;  // 256 - weight: 1 .. 256

  localparam sum_t Half = sum_t'(1) << (ChannelWidth - 1);
  localparam complement_t One = complement_t'(1) << ChannelWidth;

  logic        advance;
  logic [1:0]  valid_d, valid_q;
  complement_t weight_a;
  sum_t        product_a_d, product_a_q;
  sum_t        product_b_d, product_b_q;
  sum_t        sum;
  channel_t    value_q;

  // The whole pipe moves or the whole pipe holds.
  assign advance    = out_ready_i || !valid_q[1];
  assign in_ready_o = advance;
  assign valid_d    = {valid_q[0], in_valid_i};

  // Stage 1: the two products. 255 * 256 fits 16 bits.
  assign weight_a    = One - complement_t'(in_weight_i);
  assign product_a_d = sum_t'(in_a_i) * sum_t'(weight_a);
  assign product_b_d = sum_t'(in_b_i) * sum_t'(in_weight_i);

  // Stage 2: sum, rounded to nearest. At most 255 * 256 + 128, so it does not carry out.
  assign sum = product_a_q + product_b_q + Half;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= '0;
    end else if (advance) begin
      valid_q <= valid_d;
    end
  end

  // Data needs no reset: valid_q guards it.
  always_ff @(posedge clk_i) begin
    if (advance) begin
      product_a_q <= product_a_d;
      product_b_q <= product_b_d;
      value_q     <= sum[SumWidth-1:ChannelWidth];
    end
  end

  assign out_valid_o = valid_q[1];
  assign out_value_o = value_q;

  OutputHeldUntilTaken_A: assert property (
    @(posedge clk_i) disable iff (!rst_ni)
    out_valid_o && !out_ready_i |=> out_valid_o && $stable(out_value_o));

  logic unused_fraction;
  assign unused_fraction = ^sum[ChannelWidth-1:0];

endmodule
