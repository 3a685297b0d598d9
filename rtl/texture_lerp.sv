// out = (a * (256 - weight) + b * weight + 128) >> 8: one lerp of the bilinear and trilinear
// filter.
//
// Latency 2, one result a cycle. Equals ffgpu::lerp8w() in model/texture/filter.h for every input.

module texture_lerp (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                in_valid_i,
  output logic                in_ready_o,
  input  ffgpu_pkg::channel_t in_a_i,
  input  ffgpu_pkg::channel_t in_b_i,
  input  ffgpu_pkg::weight_t  in_weight_i,

  output logic                out_valid_o,
  input  logic                out_ready_i,
  output ffgpu_pkg::channel_t out_value_o
);

  localparam int unsigned ChannelWidth = ffgpu_pkg::ChannelWidth;
  localparam int unsigned SumWidth = 2 * ChannelWidth;

  typedef logic [SumWidth-1:0] sum_t;

  // In units of the sum's last bit: a half and one of the result's.
  localparam sum_t Half = {{ChannelWidth{1'b0}}, 1'b1, {ChannelWidth - 1{1'b0}}};
  localparam sum_t One = {{ChannelWidth - 1{1'b0}}, 1'b1, {ChannelWidth{1'b0}}};

  logic                advance;
  logic [1:0]          valid_d, valid_q;
  sum_t                a, b, weight_a, weight_b;
  sum_t                product_a_d, product_a_q;
  sum_t                product_b_d, product_b_q;
  sum_t                sum;
  ffgpu_pkg::channel_t value_q;

  // The whole pipe moves or the whole pipe holds.
  assign advance    = out_ready_i || !valid_q[1];
  assign in_ready_o = advance;
  assign valid_d    = {valid_q[0], in_valid_i};

  // Stage 1: the two products. 255 * 256 fits 16 bits.
  assign a           = {{ChannelWidth{1'b0}}, in_a_i};
  assign b           = {{ChannelWidth{1'b0}}, in_b_i};
  assign weight_b    = {{ChannelWidth{1'b0}}, in_weight_i};
  assign weight_a    = One - weight_b;
  assign product_a_d = a * weight_a;
  assign product_b_d = b * weight_b;

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

  logic unused_fraction;
  assign unused_fraction = ^sum[ChannelWidth-1:0];

endmodule
