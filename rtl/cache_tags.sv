// A set-associative cache's tags: the least recently used line of a set gives way.
//
// Combinational look-up; what it finds or replaces is kept at the clock's edge where update_i is
// high. Equals ffgpu::work::TagArray with its first policy, in the order of the updates.

module cache_tags #(
  parameter int unsigned SetBits = 4,
  parameter int unsigned WayBits = 2,
  parameter int unsigned NumberWidth = 26  // of a line: its address without the bits inside it
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic [NumberWidth-1:0] number_i,
  input  logic                   update_i,
  output logic                   hit_o,
  output logic [WayBits-1:0]     way_o  // where the line is, or will be
);

  localparam int unsigned Sets = 1 << SetBits;
  localparam int unsigned Ways = 1 << WayBits;
  localparam int unsigned TagWidth = NumberWidth - SetBits;

  // Of a set's ways, the first lowest; an age counts the lines used since, and no two are alike. At
  // first the lowest way is the oldest: lines fill a set upwards.
  logic [Ways*TagWidth-1:0]     tags_q [Sets];
  logic [Sets*Ways-1:0]         used_q;
  logic [Sets*Ways*WayBits-1:0] ages_q;

  logic [SetBits-1:0]       set;
  logic [TagWidth-1:0]      tag;
  logic [Ways*TagWidth-1:0] tags, next_tags;
  logic [Ways-1:0]          used, hits, next_used;
  logic [Ways*WayBits-1:0]  ages, next_ages;

  assign set  = number_i[SetBits-1:0];
  assign tag  = number_i[NumberWidth-1:SetBits];
  assign tags = tags_q[set];
  assign used = used_q[Ways*set +: Ways];
  assign ages = ages_q[Ways*WayBits*set +: Ways*WayBits];

  always_comb begin
    way_o = '0;
    for (int unsigned way = 0; way < Ways; way++) begin
      hits[way] = used[way] && tags[TagWidth*way +: TagWidth] == tag;
      // The oldest, unless one of them is the line.
      if (ages[WayBits*way +: WayBits] == '1) begin
        way_o = way[WayBits-1:0];
      end
    end
    for (int unsigned way = 0; way < Ways; way++) begin
      if (hits[way]) begin
        way_o = way[WayBits-1:0];
      end
    end
  end
  assign hit_o = hits != '0;

  always_comb begin
    next_tags = tags;
    next_used = used;
    for (int unsigned way = 0; way < Ways; way++) begin
      if (way_o == way[WayBits-1:0]) begin
        next_tags[TagWidth*way +: TagWidth] = tag;
        next_used[way]                      = 1'b1;
      end
    end
  end
  cache_ages #(
    .WayBits(WayBits)
  ) u_ages (
    .ages_i(ages),
    .way_i (way_o),
    .ages_o(next_ages)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      used_q <= '0;
      for (int unsigned i = 0; i < Sets * Ways; i++) begin
        ages_q[WayBits*i +: WayBits] <= ~i[WayBits-1:0];
      end
    end else if (update_i) begin
      used_q[Ways*set +: Ways]                 <= next_used;
      ages_q[Ways*WayBits*set +: Ways*WayBits] <= next_ages;
    end
  end
  always_ff @(posedge clk_i) begin
    if (update_i) begin
      tags_q[set] <= next_tags;
    end
  end

endmodule
