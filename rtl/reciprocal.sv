// The reciprocal of a binary32 number, rounded to nearest even.
//
// Latency 6, one number a cycle. Equals ffgpu::reciprocal() in model/arith/reciprocal.h for normal
// numbers whose reciprocal is normal. With x = m 2^e, m of 24 bits, 25 bits of 2^48 / m are made,
// five a stage: the lowest is the rounding bit. No quotient lies half way between two numbers,
// since that would make a power of two of an m that is none; of those that are, the fraction is 0.

module reciprocal (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     in_valid_i,
  output logic                     in_ready_o,
  input  ffgpu_pkg::tagged_float_t in_data_i,

  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output ffgpu_pkg::tagged_float_t out_data_o
);

  localparam int unsigned Stages = ffgpu_registers_pkg::ReciprocalLatency - 1;
  localparam logic [24:0] FirstRemainder = 25'h080_0000;  // 2^48 but for the 25 bits to come

  ffgpu_pkg::division_t        first, last;
  localparam int unsigned Width = $bits(first);
  logic [(Stages+1)*Width-1:0] data;
  logic [Stages:0]             valid, ready;

  assign first           = {in_data_i, FirstRemainder, 25'd0};
  assign data[Width-1:0] = first;
  assign valid[0]        = in_valid_i;
  assign in_ready_o      = ready[0];

  for (genvar stage = 0; stage < Stages; stage++) begin : g_stage
    reciprocal_stage #(
      .QuotientBits(5)
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

  ffgpu_pkg::tagged_float_t item, result;
  logic                     is_power;
  logic [22:0]              rounded;
  logic [7:0]               exponent;

  assign last     = data[Width*Stages +: Width];
  assign item     = last.item;
  assign is_power = item.value[22:0] == 23'd0;
  assign rounded  = last.quotient[23:1] + {22'd0, last.quotient[0]};
  assign exponent = (is_power ? 8'd254 : 8'd253) - item.value[30:23];

  always_comb begin
    result       = item;
    result.value = {item.value[31], exponent, is_power ? 23'd0 : rounded};
  end

  pipeline_register #(
    .Width($bits(result))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (valid[Stages]),
    .in_ready_o (ready[Stages]),
    .in_data_i  (result),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
