// texel_cache with a memory behind it that answers after any time in any order. A word of the memory
// is its address times an odd number. With what comes out stands the way of the set that its line is in.

module texel_cache_loop #(
  parameter int unsigned DataWidth = $bits(ffgpu_texture_pkg::texel_data_t)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  ffgpu_texture_pkg::texel_read_t in_data_i,

  output logic                           out_valid_o,
  input  logic                           out_ready_i,
  output logic [DataWidth+1:0]           out_data_o
);

  localparam int unsigned FillBits = 3;
  localparam int unsigned Fills = 1 << FillBits;
  localparam int unsigned Words = 16;

  logic                request_valid, request_ready, response_valid;
  logic [31:0]         request_address;
  logic [FillBits-1:0] request_fill, response_fill;
  logic [511:0]        response_line;
  logic [31:0]         random_q;
  logic [Fills-1:0]    asked_q;
  logic [31:0]         addresses_q [Fills];

  texel_cache #(
    .SetBits (2),
    .WayBits (2),
    .FillBits(FillBits)
  ) u_cache (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_data_i,
    .out_valid_o,
    .out_ready_i,
    .out_data_o       (out_data_o[2 +: DataWidth]),
    .request_valid_o  (request_valid),
    .request_ready_i  (request_ready),
    .request_address_o(request_address),
    .request_fill_o   (request_fill),
    .response_valid_i (response_valid),
    .response_fill_i  (response_fill),
    .response_line_i  (response_line)
  );

  // Beside the cache's last register, and in step with it.
  logic unused_ready, unused_valid;

  pipeline_register #(
    .Width(2)
  ) u_way (
    .clk_i,
    .rst_ni,
    .in_valid_i (u_cache.head_valid && u_cache.is_there),
    .in_ready_o (unused_ready),
    .in_data_i  (u_cache.head_place[2 +: 2]),
    .out_valid_o(unused_valid),
    .out_ready_i,
    .out_data_o (out_data_o[1:0])
  );

  // A look-up leaves its line's tag in its line's set, at the way that it names.
  localparam int unsigned TagWidth = 24;
  logic        looked_up_q;
  logic [1:0]  set_q, way_q;
  logic [TagWidth-1:0] tag_q;

  always_ff @(posedge clk_i) begin
    looked_up_q <= rst_ni && u_cache.enters;
    {tag_q, set_q} <= in_data_i.address[31:6];
    way_q <= u_cache.way;
    if (looked_up_q && rst_ni) begin
      assert (u_cache.u_tags.tags_q[set_q][TagWidth*way_q +: TagWidth] == tag_q)
      else $error("%m: set %0d, way %0d: another line's tag", set_q, way_q);
    end
  end

  // One of the lines that are asked for, or none; no request in an eighth of the cycles.
  assign request_ready  = random_q[31:29] != 3'd0;
  assign response_fill  = random_q[8 +: FillBits];
  assign response_valid = asked_q[response_fill] && random_q[3:2] == 2'd0;
  always_comb begin
    for (int unsigned i = 0; i < Words; i++) begin
      response_line[32*i +: 32] = (addresses_q[response_fill] + 4 * i) * 32'h9e37_79b1;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      asked_q  <= '0;
      random_q <= 32'h1234_5678;
    end else begin
      random_q <= {random_q[30:0], random_q[31] ^ random_q[21] ^ random_q[1] ^ random_q[0]};
      if (response_valid) begin
        asked_q[response_fill] <= 1'b0;
      end
      if (request_valid && request_ready) begin
        asked_q[request_fill] <= 1'b1;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (request_valid && request_ready) begin
      addresses_q[request_fill] <= request_address;
    end
  end

endmodule
