// The ages of a cache's ways when one of them is used: it is the newest, and those that were newer
// are a use older.
//
// Combinational. No two ages are alike, and none will be (tests/rtl/mutate.py has it proved).

module cache_ages #(
  parameter int unsigned WayBits = 2
) (
  input  logic [WayBits*(1<<WayBits)-1:0] ages_i,  // first way lowest; 0: used last
  input  logic [WayBits-1:0]              way_i,
  output logic [WayBits*(1<<WayBits)-1:0] ages_o
);

  logic [WayBits-1:0] age;

  assign age = ages_i[WayBits*way_i +: WayBits];
  always_comb begin
    ages_o = ages_i;
    for (int unsigned way = 0; way < 1 << WayBits; way++) begin
      if (ages_i[WayBits*way +: WayBits] < age) begin
        ages_o[WayBits*way +: WayBits] = ages_i[WayBits*way +: WayBits] + 1'b1;
      end
    end
    ages_o[WayBits*way_i +: WayBits] = '0;
  end

endmodule
