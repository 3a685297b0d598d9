// Depth bounds, stencil test and depth test of one fragment, and the pixel afterwards.
//
// Combinational. Equals ffgpu::test_stencil_depth() in model/fragment/stencil_depth.cpp.

module stencil_depth_core (
  input  ffgpu_registers_pkg::stencil_t       stencil_i,
  input  ffgpu_registers_pkg::depth_control_t depth_control_i,
  input  logic [4:0]                          format_i,
  input  logic                                front_facing_i,
  input  ffgpu_pkg::depth_t                   depth_i,
  input  ffgpu_pkg::pixel_t                   stored_i,

  output logic                                passes_o,
  output ffgpu_pkg::pixel_t                   pixel_o,
  output logic                                writes_depth_o,
  output logic                                writes_stencil_o
);

  localparam int unsigned FaceWidth = 3 + 3 * 3 + 3 * 8;

  logic                            is_depth24, is_depth16, tests_stencil, in_bounds;
  logic                            tests_depth, passes_stencil, passes_depth;
  ffgpu_pkg::depth_t               stored_depth;
  logic [7:0]                      stored_stencil, reference, compare_mask, write_mask;
  logic [7:0]                      changed, new_stencil;
  logic [FaceWidth-1:0]            face;
  ffgpu_registers_pkg::compare_e   relation;
  ffgpu_registers_pkg::stencil_op_e fail, depth_fail, depth_pass, operation;

  // What the target lacks is switched off.
  assign is_depth24     = format_i == ffgpu_registers_pkg::FormatDepth24Stencil8;
  assign is_depth16     = format_i == ffgpu_registers_pkg::FormatDepth16;
  assign stored_depth   = is_depth16 ? {8'd0, stored_i[15:0]} : stored_i[31:8];
  assign stored_stencil = stored_i[7:0];
  assign tests_stencil  = stencil_i.enable && is_depth24;
  assign tests_depth    = depth_control_i.test_enable && (is_depth24 || is_depth16);

  assign face = front_facing_i ?
    {stencil_i.front_compare, stencil_i.front_fail, stencil_i.front_depth_fail,
     stencil_i.front_depth_pass, stencil_i.front_reference, stencil_i.front_compare_mask,
     stencil_i.front_write_mask} :
    {stencil_i.back_compare, stencil_i.back_fail, stencil_i.back_depth_fail,
     stencil_i.back_depth_pass, stencil_i.back_reference, stencil_i.back_compare_mask,
     stencil_i.back_write_mask};
  assign {relation, fail, depth_fail, depth_pass, reference, compare_mask, write_mask} = face;

  assign in_bounds = !(depth_control_i.bounds_enable && (is_depth24 || is_depth16)) ||
    (stored_depth >= depth_control_i.bounds_min && stored_depth <= depth_control_i.bounds_max);
  assign passes_stencil = in_bounds && (!tests_stencil ||
    ffgpu_pkg::compare(relation, {16'd0, reference & compare_mask},
                       {16'd0, stored_stencil & compare_mask}));
  assign passes_depth = passes_stencil && (!tests_depth ||
    ffgpu_pkg::compare(depth_control_i.compare, depth_i, stored_depth));

  assign operation = !passes_stencil ? fail : passes_depth ? depth_pass : depth_fail;

  always_comb begin
    unique case (operation)
      ffgpu_registers_pkg::StencilOpKeep:    changed = stored_stencil;
      ffgpu_registers_pkg::StencilOpZero:    changed = 8'd0;
      ffgpu_registers_pkg::StencilOpReplace: changed = reference;
      ffgpu_registers_pkg::StencilOpIncrement:
        changed = stored_stencil == 8'd255 ? 8'd255 : stored_stencil + 8'd1;
      ffgpu_registers_pkg::StencilOpDecrement:
        changed = stored_stencil == 8'd0 ? 8'd0 : stored_stencil - 8'd1;
      ffgpu_registers_pkg::StencilOpInvert:        changed = ~stored_stencil;
      ffgpu_registers_pkg::StencilOpIncrementWrap: changed = stored_stencil + 8'd1;
      ffgpu_registers_pkg::StencilOpDecrementWrap: changed = stored_stencil - 8'd1;
    endcase
  end

  assign new_stencil      = (stored_stencil & ~write_mask) | (changed & write_mask);
  assign passes_o         = passes_depth;
  assign writes_depth_o   = passes_depth && tests_depth && depth_control_i.write_enable;
  assign writes_stencil_o = tests_stencil && in_bounds;

  always_comb begin
    pixel_o = stored_i;
    if (writes_stencil_o) begin
      pixel_o[7:0] = new_stencil;
    end
    if (writes_depth_o && is_depth16) begin
      pixel_o[15:0] = depth_i[15:0];
    end
    if (writes_depth_o && is_depth24) begin
      pixel_o[31:8] = depth_i;
    end
  end

endmodule
