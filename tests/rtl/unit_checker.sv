// What every unit promises at its channels. For simulation: bound to a unit by
// tests/rtl/unit_checks.sv.in, so that the unit holds nothing that synthesis cannot read.
//
// Nothing is lost, doubled or reordered: the bench compares each output with the one that is due,
// and here items are counted. Ready without a look at the own valid: the bench as well.

module unit_checker #(
  parameter int unsigned InWidth = 8,
  parameter int unsigned OutWidth = 8,
  parameter bit          OneToOne = 1'b1,  // an output for each input
  parameter bit          InDataHeld = 1'b1,  // offered data stay; else they are made when they go
  parameter int unsigned MostInside = 64,
  parameter int unsigned MostIdle = 64     // cycles in which a receiver that takes gets nothing
) (
  input logic                clk_i,
  input logic                rst_ni,
  input logic                in_valid_i,
  input logic                in_ready_i,
  input logic [InWidth-1:0]  in_data_i,
  input logic                out_valid_i,
  input logic                out_ready_i,
  input logic [OutWidth-1:0] out_data_i
);

  int unsigned         inside_q, idle_q;
  logic                taken, given, in_held_q, out_held_q;
  logic [InWidth-1:0]  in_data_q;
  logic [OutWidth-1:0] out_data_q;

  assign taken = in_valid_i && in_ready_i;
  assign given = out_valid_i && out_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      inside_q   <= 0;
      idle_q     <= 0;
      in_held_q  <= 1'b0;
      out_held_q <= 1'b0;
    end else begin
      if (OneToOne) begin
        inside_q <= inside_q + {31'd0, taken} - {31'd0, given};
      end
      idle_q     <= given || !out_ready_i || (OneToOne && inside_q == 0) ? 0 : idle_q + 1;
      in_held_q  <= in_valid_i && !in_ready_i;
      out_held_q <= out_valid_i && !out_ready_i;
    end
  end

  // Immediate assertions with flops of their own: 5.006 samples wide data of concurrent ones by
  // code that does not compile.
  always_ff @(posedge clk_i) begin
    in_data_q  <= in_data_i;
    out_data_q <= out_data_i;
    if (rst_ni) begin
      InHeldUntilTaken_A : assert (!in_held_q ||
                                   (in_valid_i && (!InDataHeld || in_data_i == in_data_q)));
      OutHeldUntilTaken_A : assert (!out_held_q || (out_valid_i && out_data_i == out_data_q));
      NothingFromNothing_A : assert (!OneToOne || !given || inside_q != 0);
      Bounded_A : assert (inside_q <= MostInside);
      Progress_A : assert (!OneToOne || idle_q <= MostIdle);
    end
  end

endmodule
