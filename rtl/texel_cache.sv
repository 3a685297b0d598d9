// The texel cache: blocks of 16 bytes by their addresses, in the order of the requests, whatever the
// memory's latency and order are.
//
// A request a cycle where lines are there. Tags run ahead of the data (Igehy, Eldridge and Proudfoot
// 1998): a miss takes its line's place and asks the memory at once, and the request waits in a
// queue behind those before it; when its turn comes the line is moved from where the memory has put
// it into the cache. What hits and misses is what ffgpu::work::TagArray says for the same order.

module texel_cache #(
  parameter int unsigned SetBits = ffgpu_registers_pkg::CacheSetBits,
  parameter int unsigned WayBits = ffgpu_registers_pkg::CacheWayBits,
  parameter int unsigned LineBits = ffgpu_registers_pkg::LineBits,  // of an address inside a line: 5 or more
  parameter int unsigned FillBits = ffgpu_registers_pkg::FillBits,  // lines on their way, as a power of two
  parameter int unsigned QueueDepth = ffgpu_registers_pkg::TexelQueue
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  ffgpu_texture_pkg::texel_read_t in_data_i,

  output logic                           out_valid_o,
  input  logic                           out_ready_i,
  output ffgpu_texture_pkg::texel_data_t out_data_o,

  // The memory is asked for lines, and answers in any order, one line a cycle.
  output logic                           request_valid_o,
  input  logic                           request_ready_i,
  output logic [31:0]                    request_address_o,
  output logic [FillBits-1:0]            request_fill_o,
  input  logic                           response_valid_i,
  input  logic [FillBits-1:0]            response_fill_i,
  input  logic [(8<<LineBits)-1:0]       response_line_i
);

  localparam int unsigned Fills = 1 << FillBits;
  localparam int unsigned Lines = 1 << (SetBits + WayBits);
  localparam int unsigned LineWidth = 8 << LineBits;
  localparam int unsigned BlockBits = LineBits - 4;  // the block's number in its line
  localparam int unsigned PlaceWidth = SetBits + WayBits + BlockBits;
  localparam int unsigned EntryWidth = 11 + PlaceWidth + 1 + FillBits;
  localparam int unsigned NumberWidth = 32 - LineBits;

  // Look-up. It sees neither the request's valid nor whether it will miss.
  logic                   enters, hit, misses, queue_ready, memory_ready;
  logic [WayBits-1:0]     way;
  logic [NumberWidth-1:0] number;
  logic [PlaceWidth-1:0]  place;
  logic [FillBits:0]      first_fill_q, next_fill_q;  // With a bit more, which tells all from none.

  assign number     = in_data_i.address[31:LineBits];
  assign place      = {number[SetBits-1:0], way, in_data_i.address[LineBits-1:4]};
  assign in_ready_o = queue_ready && memory_ready &&
    first_fill_q != {~next_fill_q[FillBits], next_fill_q[FillBits-1:0]};
  assign enters     = in_valid_i && in_ready_o;
  assign misses     = enters && !hit;

  cache_tags #(
    .SetBits    (SetBits),
    .WayBits    (WayBits),
    .NumberWidth(NumberWidth)
  ) u_tags (
    .clk_i,
    .rst_ni,
    .number_i(number),
    .update_i(enters),
    .hit_o   (hit),
    .way_o   (way)
  );

  pipeline_register #(
    .Width(32 + FillBits)
  ) u_request (
    .clk_i,
    .rst_ni,
    .in_valid_i (misses),
    .in_ready_o (memory_ready),
    .in_data_i  ({number, {LineBits{1'b0}}, next_fill_q[FillBits-1:0]}),
    .out_valid_o(request_valid_o),
    .out_ready_i(request_ready_i),
    .out_data_o ({request_address_o, request_fill_o})
  );

  // Requests in their order, each with where its line is or will be.
  logic                  head_valid, head_ready, head_missed, is_there, moves;
  logic                  out_ready;
  logic [10:0]           head_name;
  logic [PlaceWidth-1:0] head_place;
  logic [FillBits-1:0]   head_fill;

  fifo #(
    .Width(EntryWidth),
    .Depth(QueueDepth)
  ) u_queue (
    .clk_i,
    .rst_ni,
    .in_valid_i (enters),
    .in_ready_o (queue_ready),
    .in_data_i  ({in_data_i.tag, in_data_i.place, place, !hit, next_fill_q[FillBits-1:0]}),
    .out_valid_o(head_valid),
    .out_ready_i(head_ready),
    .out_data_o ({head_name, head_place, head_missed, head_fill})
  );

  // Lines that have come, and the cache's own.
  logic [Fills-1:0]     come_q;
  logic [LineWidth-1:0] filled_q [Fills];
  logic [LineWidth-1:0] lines_q [Lines];
  logic [LineWidth-1:0] line;
  logic [127:0]         block;

  assign is_there   = !head_missed || come_q[head_fill];
  assign head_ready = out_ready && is_there;
  assign moves      = head_valid && head_ready && head_missed;
  assign line       = head_missed ? filled_q[head_fill] : lines_q[head_place[PlaceWidth-1:BlockBits]];
  assign block      = line[128*head_place[BlockBits-1:0] +: 128];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      first_fill_q <= '0;
      next_fill_q  <= '0;
      come_q       <= '0;
    end else begin
      first_fill_q <= first_fill_q + {{FillBits{1'b0}}, moves};
      next_fill_q  <= next_fill_q + {{FillBits{1'b0}}, misses};
      if (response_valid_i) begin
        come_q[response_fill_i] <= 1'b1;
      end
      if (moves) begin
        come_q[head_fill] <= 1'b0;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (response_valid_i) begin
      filled_q[response_fill_i] <= response_line_i;
    end
    if (moves) begin
      lines_q[head_place[PlaceWidth-1:BlockBits]] <= line;
    end
  end

  pipeline_register #(
    .Width(12 + 128)
  ) u_out (
    .clk_i,
    .rst_ni,
    .in_valid_i (head_valid && is_there),
    .in_ready_o (out_ready),
    .in_data_i  ({head_name, head_missed, block}),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
