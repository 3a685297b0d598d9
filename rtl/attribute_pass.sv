// The second visit of a quad to its primitive's planes: attribute after attribute that varies, each
// times w, or 1/q of its texture unit.
//
// An attribute a cycle, and a cycle for w. The quad itself goes ahead of its values, to
// quad_collect. A value's place: attribute, and above it whether it is the quad's last (bit 6) and
// its texture unit's (bit 7).

module attribute_pass (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  // By the quad's tag: the attributes that its primitives carry.
  input  logic [47:0]                     carried_0_i,
  input  logic [47:0]                     carried_1_i,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  ffgpu_pipe_pkg::slotted_quad_t   in_data_i,

  input  logic                            divisor_valid_i,
  output logic                            divisor_ready_o,
  input  logic [127:0]                    divisor_i,

  // The record store.
  input  logic [4*129-1:0]                headers_i,
  input  logic [4*64-1:0]                 q_scales_i,
  output logic [1:0]                      slot_o,
  output logic [5:0]                      attribute_o,
  input  ffgpu_pipe_pkg::plane_t          plane_i,

  output logic                            quad_valid_o,
  input  logic                            quad_ready_i,
  output ffgpu_pipe_pkg::collected_quad_t quad_o,

  output logic                            out_valid_o,
  input  logic                            out_ready_i,
  output ffgpu_pkg::lane_values_t         out_data_o
);

  localparam int unsigned HeaderWidth = 129;
  localparam int unsigned FactorsDepth = 4;
  localparam logic [31:0] One = 32'h3f80_0000;
  localparam logic [7:0] LeastScale = 8'd69;  // 2^-58
  localparam logic [7:0] LargestScale = 8'd204;  // 2^77

  ffgpu_pipe_pkg::shading_header_t header;
  ffgpu_pkg::quad_t                quad;
  ffgpu_pkg::plane_quad_t          plane_quad;
  ffgpu_pkg::lane_values_t         integers;
  ffgpu_pkg::perspective_quad_t    product;
  logic [47:0]  carried, all, left_q, left, others;
  logic         started_q, has_w_q, uses_w, none, is_last, is_unit_last, is_coordinate, divides;
  logic         takes_q, takes_w, can_issue, issues, plane_valid, plane_ready;
  logic         factors_valid, factors_ready, integers_valid, product_ready;
  logic [127:0] w_q, over_q_q, factors, next_factors;
  logic [2:0]   unit, kind, next_kind;
  logic [7:0]   q_scale, scale, next_scale, quotient_scale;

  assign quad    = in_data_i.quad;
  assign header  = headers_i[HeaderWidth*in_data_i.slot +: HeaderWidth];
  assign carried = quad.tag ? carried_1_i : carried_0_i;
  assign all     = ffgpu_pipe_pkg::varying(carried, header.constant_color,
                                           header.constant_secondary) &
    ~ffgpu_pipe_pkg::ProjectiveMask;
  assign uses_w  = header.perspective &&
    ffgpu_pipe_pkg::varying(carried, header.constant_color, header.constant_secondary) != 48'd0;
  assign left    = started_q ? left_q : all;

  lowest_attribute u_lowest (
    .attributes_i(left),
    .lowest_o    (attribute_o),
    .others_o    (others)
  );

  assign slot_o        = in_data_i.slot;
  assign none          = left == 48'd0;
  assign is_last       = others == 48'd0;
  assign is_coordinate = attribute_o[5:4] != 2'd0;
  assign unit          = {attribute_o[5], attribute_o[3:2]};
  assign is_unit_last  = is_coordinate && others[{attribute_o[5:2], 2'b00} +: 4] == 4'd0;
  assign divides       = is_coordinate && header.divided_units[unit];
  assign takes_q       = divides && attribute_o[1:0] == 2'd0;
  assign takes_w       = in_valid_i && uses_w && !has_w_q;
  assign can_issue     = !none && (!uses_w || has_w_q) && (!takes_q || divisor_valid_i) &&
    (started_q || quad_ready_i);
  assign plane_valid   = in_valid_i && can_issue && factors_ready;
  assign issues        = plane_valid && plane_ready;

  assign divisor_ready_o = takes_w || (issues && takes_q);
  assign quad_valid_o    = in_valid_i && (none || (issues && !started_q));
  assign in_ready_o      = none ? quad_ready_i :
    can_issue && factors_ready && plane_ready && is_last;

  always_comb begin
    quad_o.has_values         = all != 48'd0;
    quad_o.constant_color     = header.constant_color;
    quad_o.constant_secondary = header.constant_secondary;
    quad_o.color              = header.color;
    quad_o.secondary          = header.secondary;
    quad_o.quad               = quad;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
      has_w_q   <= 1'b0;
    end else if (issues) begin
      started_q <= !is_last;
      has_w_q   <= has_w_q && !is_last;
    end else if (takes_w && divisor_valid_i) begin
      has_w_q <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (takes_w && divisor_valid_i) begin
      w_q <= divisor_i;
    end
    if (issues) begin
      left_q <= others;
    end
    if (issues && takes_q) begin
      over_q_q <= divisor_i;
    end
  end

  // Integers, and beside them what they are multiplied by.
  assign q_scale        = q_scales_i[{in_data_i.slot, unit, 3'd0} +: 8];
  // Planes' exponents are in -40 .. 79, so that one less another is in 8 bits with the bias.
  assign quotient_scale = plane_i.scale - q_scale + 8'd127;
  always_comb begin
    next_kind    = 3'd0;
    next_factors = header.perspective ? w_q : {4{One}};
    next_scale   = plane_i.scale;
    if (attribute_o == ffgpu_pipe_pkg::AttributeFog) begin
      next_kind = ffgpu_pkg::PerspectiveFog;
    end else if (!is_coordinate) begin
      next_kind = ffgpu_pkg::PerspectiveColor;
    end
    if (divides) begin
      next_factors = takes_q ? divisor_i : over_q_q;
      next_scale   = quotient_scale;
      if (quotient_scale < LeastScale) begin
        next_scale = LeastScale;
      end else if (quotient_scale > LargestScale) begin
        next_scale = LargestScale;
      end
    end
  end

  assign plane_quad = {quad.tag, 2'd0, is_unit_last, is_last, attribute_o,
                       {2'd0, quad.x} - header.x_reference, {2'd0, quad.y} - header.y_reference,
                       plane_i.whole, plane_i.fraction, plane_i.dx, plane_i.dy};

  attribute_plane u_plane (
    .clk_i,
    .rst_ni,
    .in_valid_i (plane_valid),
    .in_ready_o (plane_ready),
    .in_data_i  (plane_quad),
    .out_valid_o(integers_valid),
    .out_ready_i(product_ready && factors_valid),
    .out_data_o (integers)
  );
  fifo #(
    .Width(3 + 8 + 128),
    .Depth(FactorsDepth)
  ) u_factors (
    .clk_i,
    .rst_ni,
    .in_valid_i (issues),
    .in_ready_o (factors_ready),
    .in_data_i  ({next_kind, next_scale, next_factors}),
    .out_valid_o(factors_valid),
    .out_ready_i(product_ready && integers_valid),
    .out_data_o ({kind, scale, factors})
  );

  assign product = {integers.tag, integers.place, kind, 32'd0, scale, factors, integers.values};

  perspective u_perspective (
    .clk_i,
    .rst_ni,
    .in_valid_i (integers_valid && factors_valid),
    .in_ready_o (product_ready),
    .in_data_i  (product),
    .out_valid_o,
    .out_ready_i,
    .out_data_o
  );

endmodule
