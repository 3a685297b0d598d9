// How an axis of a texture's level is addressed: its sizes, and its wrap mode as constants.
//
// Combinational. Equals ffgpu::wrap_rule() in model/texture/wrap.h. Rectangles know the clamping
// modes only: another one clamps to the edge.

module axis_rule #(
  parameter int unsigned Axis = 0
) (
  input  logic                                enable_i,  // low: nobody looks at the rule
  input  ffgpu_registers_pkg::texture_image_t image_i,
  input  ffgpu_registers_pkg::sampler_t       sampler_i,
  input  ffgpu_texture_pkg::texel_header_t    header_i,
  output ffgpu_texture_pkg::axis_rule_t       rule_o
);

  localparam logic [23:0] Half = 24'd128;

  ffgpu_registers_pkg::wrap_e told, wrap;
  logic                       clamps, is_linear, is_rectangle;
  logic [12:0]                size, shifted;

  always_comb begin
    size         = 13'd0;
    shifted      = 13'd0;
    told         = ffgpu_registers_pkg::WrapClampToEdge;
    wrap         = ffgpu_registers_pkg::WrapClampToEdge;
    clamps       = 1'b0;
    is_linear    = 1'b0;
    is_rectangle = 1'b0;
    rule_o       = '0;
    if (enable_i) begin
      is_rectangle = image_i.kind == ffgpu_registers_pkg::TextureKindRectangle;
      is_linear    = header_i.linear;
      size         = Axis == 0 ? image_i.width : Axis == 1 ? image_i.height : {3'd0, image_i.depth};
      shifted      = size >> header_i.level;

      told   = Axis == 0 ? sampler_i.wrap_0 : Axis == 1 ? sampler_i.wrap_1 : sampler_i.wrap_2;
      clamps = told == ffgpu_registers_pkg::WrapClamp ||
        told == ffgpu_registers_pkg::WrapClampToEdge ||
        told == ffgpu_registers_pkg::WrapClampToBorder;
      wrap = is_rectangle && !clamps ? ffgpu_registers_pkg::WrapClampToEdge : told;

      rule_o.is_rectangle = is_rectangle;
      rule_o.size = size;
      rule_o.level_size = shifted == 13'd0 ? 13'd1 : shifted;
      rule_o.fold = ffgpu_texture_pkg::FoldClamp;
      rule_o.wraps = 1'b0;
      rule_o.border = 1'b0;
      rule_o.low = 24'd0;
      rule_o.above = 24'd0;
      unique case (wrap)
        ffgpu_registers_pkg::WrapRepeat: begin
          rule_o.fold = ffgpu_texture_pkg::FoldRepeat;
          rule_o.wraps = 1'b1;
        end
        ffgpu_registers_pkg::WrapMirroredRepeat: begin
          rule_o.fold = ffgpu_texture_pkg::FoldMirror;
          rule_o.low = Half;
          rule_o.above = -Half;
        end
        ffgpu_registers_pkg::WrapClamp: rule_o.border = is_linear;
        ffgpu_registers_pkg::WrapClampToEdge: begin
          rule_o.low = Half;
          rule_o.above = -Half;
        end
        ffgpu_registers_pkg::WrapClampToBorder: begin
          rule_o.border = 1'b1;
          rule_o.low = -Half;
          rule_o.above = Half;
        end
        ffgpu_registers_pkg::WrapMirrorClamp: begin
          rule_o.fold = ffgpu_texture_pkg::FoldMirrorClamp;
          rule_o.border = is_linear;
          rule_o.low = Half;
        end
        ffgpu_registers_pkg::WrapMirrorClampToEdge: begin
          rule_o.fold = ffgpu_texture_pkg::FoldMirrorClamp;
          rule_o.low = Half;
          rule_o.above = -Half;
        end
        ffgpu_registers_pkg::WrapMirrorClampToBorder: begin
          rule_o.fold = ffgpu_texture_pkg::FoldMirrorClamp;
          rule_o.border = 1'b1;
          rule_o.low = Half;
          rule_o.above = Half;
        end
      endcase
    end
  end

endmodule
