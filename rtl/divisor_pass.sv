// The first visit of a quad to its primitive's planes: w, where the primitive has perspective, and
// then 1/q of each texture unit that divides by it, unit after unit. They go into a queue of their
// own, in the order in which attribute_pass will want them; quads go on in theirs.
//
// A divisor a cycle; a quad without any takes one cycle.

module divisor_pass #(
  parameter int unsigned QuadDepth = ffgpu_registers_pkg::DividedQuads,
  parameter int unsigned DivisorDepth = 16
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  // By the quad's tag: the attributes that its primitives carry.
  input  logic [47:0]                     carried_0_i,
  input  logic [47:0]                     carried_1_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pipe_pkg::slotted_quad_t   in_data_i,

  // The record store.
  input  logic [4*129-1:0]                headers_i,
  output logic [1:0]                      slot_o,
  output logic [5:0]                      attribute_o,
  input  ffgpu_pipe_pkg::plane_t          plane_i,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output ffgpu_pipe_pkg::slotted_quad_t   out_data_o,

  output logic                            divisor_valid_o,
  input  logic                            divisor_ready_i,
  output logic [127:0]                    divisor_o
);

  localparam int unsigned HeaderWidth = 129;
  localparam logic [31:0] One = 32'h3f80_0000;

  ffgpu_pipe_pkg::shading_header_t header, result_header;
  ffgpu_pkg::quad_t                quad;
  ffgpu_pkg::plane_quad_t          plane_quad;
  ffgpu_pkg::lane_values_t         integers, divisors;
  ffgpu_pkg::perspective_quad_t    numbers;
  logic [47:0]                     carried, all, left_q, left, others;
  logic                            started_q, is_last, none, issues, quads_ready, quads_valid;
  logic                            plane_valid, plane_ready, integers_valid, integers_ready;
  logic                            divisors_valid, divisors_ready, fifo_ready;
  logic [3:0]                      reciprocal_ready, reciprocal_valid;
  logic [127:0]                    reciprocals;

  assign quad    = in_data_i.quad;
  assign header  = headers_i[HeaderWidth*in_data_i.slot +: HeaderWidth];
  assign carried = quad.tag ? carried_1_i : carried_0_i;

  always_comb begin
    all = 48'd0;
    if (header.perspective && ffgpu_pipe_pkg::varying(carried, header.constant_color,
                                                      header.constant_secondary) != 48'd0) begin
      all[0] = 1'b1;
    end
    for (int unsigned unit = 0; unit < 8; unit++) begin
      all[4*unit+19] = carried[4*unit+19] && header.divided_units[unit];
    end
  end
  assign left = started_q ? left_q : all;

  lowest_attribute u_lowest (
    .attributes_i(left),
    .lowest_o    (attribute_o),
    .others_o    (others)
  );

  assign slot_o      = in_data_i.slot;
  assign none        = left == 48'd0;
  assign is_last     = others == 48'd0;
  assign plane_valid = in_valid_i && !none && (!is_last || quads_ready);
  assign issues      = plane_valid && plane_ready;
  assign quads_valid = in_valid_i && (none || (is_last && plane_ready));
  assign in_ready_o  = quads_ready && (none || (is_last && plane_ready));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
    end else if (issues) begin
      started_q <= !is_last;
    end
  end
  always_ff @(posedge clk_i) begin
    if (issues) begin
      left_q <= others;
    end
  end

  fifo #(
    .Width($bits(in_data_i)),
    .Depth(QuadDepth)
  ) u_quads (
    .clk_i,
    .rst_ni,
    .in_valid_i (quads_valid),
    .in_ready_o (quads_ready),
    .in_data_i,
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

  // The plane's integers, the number to divide by, its reciprocal.
  assign plane_quad = {quad.tag, 2'd0, in_data_i.slot, attribute_o,
                       {2'd0, quad.x} - header.x_reference, {2'd0, quad.y} - header.y_reference,
                       plane_i.whole, plane_i.fraction, plane_i.dx, plane_i.dy};

  attribute_plane u_plane (
    .clk_i,
    .rst_ni,
    .in_valid_i (plane_valid),
    .in_ready_o (plane_ready),
    .in_data_i  (plane_quad),
    .out_valid_o(integers_valid),
    .out_ready_i(integers_ready),
    .out_data_o (integers)
  );

  assign result_header = headers_i[HeaderWidth*integers.place[7:6] +: HeaderWidth];
  assign numbers       = {integers.tag, integers.place,
                          integers.place[5:0] == ffgpu_pipe_pkg::AttributeInverseW ?
                            ffgpu_pkg::PerspectiveInverseW : ffgpu_pkg::PerspectiveQ,
                          result_header.inverse_w_floor, 8'd127, {4{One}},
                          integers.values};

  perspective u_numbers (
    .clk_i,
    .rst_ni,
    .in_valid_i (integers_valid),
    .in_ready_o (integers_ready),
    .in_data_i  (numbers),
    .out_valid_o(divisors_valid),
    .out_ready_i(divisors_ready),
    .out_data_o (divisors)
  );

  // The four lanes' dividers go in step.
  assign divisors_ready = reciprocal_ready[0];
  for (genvar lane = 0; lane < 4; lane++) begin : g_lane
    logic [42:0] result;

    reciprocal u_reciprocal (
      .clk_i,
      .rst_ni,
      .in_valid_i (divisors_valid),
      .in_ready_o (reciprocal_ready[lane]),
      .in_data_i  ({divisors.tag, divisors.place, divisors.values[32*lane +: 32]}),
      .out_valid_o(reciprocal_valid[lane]),
      .out_ready_i(fifo_ready),
      .out_data_o (result)
    );
    assign reciprocals[32*lane +: 32] = result[31:0];
  end

  fifo #(
    .Width(ffgpu_pipe_pkg::DivisorWidth),
    .Depth(DivisorDepth)
  ) u_divisors (
    .clk_i,
    .rst_ni,
    .in_valid_i (reciprocal_valid[0]),
    .in_ready_o (fifo_ready),
    .in_data_i  (reciprocals),
    .out_valid_o(divisor_valid_o),
    .out_ready_i(divisor_ready_i),
    .out_data_o (divisor_o)
  );

endmodule
