// What every valid/ready channel promises: what is offered stays until it is taken.
//
// For simulation: tests/rtl/UNIT_checks.sv binds it to the channels of a unit, which so holds
// nothing that synthesis cannot read.

module channel_checker #(
  parameter int unsigned Width = 8
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             valid_i,
  input logic             ready_i,
  input logic [Width-1:0] data_i
);

  OfferedUntilTaken_A: assert property (
    @(posedge clk_i) disable iff (!rst_ni)
    valid_i && !ready_i |=> valid_i && $stable(data_i));

endmodule
