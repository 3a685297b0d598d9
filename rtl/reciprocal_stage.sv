// Some bits of a quotient, the highest first, by subtraction.
//
// Latency 1, one number a cycle.

module reciprocal_stage #(
  parameter int unsigned QuotientBits = 5
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  input  logic                 in_valid_i,
  output logic                 in_ready_o,
  input  ffgpu_pkg::division_t in_data_i,

  output logic                 out_valid_o,
  input  logic                 out_ready_i,
  output ffgpu_pkg::division_t out_data_o
);

  localparam int unsigned Width = 25;

  ffgpu_pkg::tagged_float_t item;
  ffgpu_pkg::division_t     divided;
  logic [Width-1:0]         divisor, remainder;
  logic [QuotientBits-1:0]  bits;

  assign item    = in_data_i.item;
  assign divisor = {2'b01, item.value[22:0]};

  always_comb begin
    remainder = in_data_i.remainder;
    bits      = '0;
    if (in_valid_i && in_ready_o) begin
      for (int i = QuotientBits - 1; i >= 0; i--) begin
        remainder = {remainder[Width-2:0], 1'b0};
        bits[i]   = remainder >= divisor;
        if (bits[i]) begin
          remainder = remainder - divisor;
        end
      end
    end
  end

  assign divided = {item, remainder, in_data_i.quotient[Width-1-QuotientBits:0], bits};

  pipeline_register #(
    .Width($bits(divided))
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i(divided),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
