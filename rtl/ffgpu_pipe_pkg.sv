// Types of the fragment pipe's own parts: what set-up hands over, what a draw is told, and what
// travels between the units. Widths in figures, as docs/rtl_style.md asks of packages.
package ffgpu_pipe_pkg;

  // Attributes of a primitive by number: its plane's place in a slot of the record store.
  localparam int unsigned Attributes = 48;
  localparam logic [5:0] AttributeInverseW = 6'd0;
  localparam logic [5:0] AttributeFog = 6'd1;
  // The primary colour is 4 to 7, the secondary one 8 to 10, s t r q of unit u 16 + 4 u and on.
  localparam logic [47:0] PrimaryMask = 48'h0000_0000_00f0;
  localparam logic [47:0] SecondaryMask = 48'h0000_0000_0700;
  localparam logic [47:0] ProjectiveMask = 48'h8888_8888_0000;  // all q

  localparam int unsigned Slots = 4;  // of primitives between set-up and the last attribute
  localparam int unsigned SlotWidth = 2;

  // ffgpu::AttributePlane as plane_quad_t wants it, and its scale's biased exponent.
  typedef struct packed {
    logic [31:0] whole;
    logic [13:0] fraction;
    logic [44:0] dx;
    logic [44:0] dy;
    logic [7:0]  scale;
  } plane_t;
  typedef struct packed {
    logic [5:0]   attribute;
    logic [143:0] plane;  // plane_t
  } plane_write_t;

  // What shading needs of a primitive beside its planes.
  typedef struct packed {
    logic [14:0] x_reference;  // signed, as y
    logic [14:0] y_reference;
    logic        perspective;
    logic        constant_color;
    logic        constant_secondary;
    logic [31:0] color;
    logic [23:0] secondary;
    logic [31:0] inverse_w_floor;  // signed
    logic [7:0]  divided_units;
  } shading_header_t;

  // ffgpu::SetupRecord without its planes, which come before it.
  typedef struct packed {
    logic         tag;
    logic [95:0]  key;
    logic         front_facing;
    logic [13:0]  box_x0;
    logic [13:0]  box_y0;
    logic [13:0]  box_x1;
    logic [13:0]  box_y1;
    logic [2:0]   edge_count;
    logic [91:0]  a;
    logic [91:0]  b;
    logic [179:0] c;
    logic [63:0]  depth_origin;
    logic [63:0]  depth_dx;
    logic [63:0]  depth_dy;
    logic [23:0]  depth_min;
    logic [23:0]  depth_max;
    logic [128:0] shading;  // shading_header_t
  } setup_record_t;

  // A quad and the slot of its primitive.
  typedef struct packed {
    logic [1:0]   slot;
    logic [383:0] quad;  // quad_t
  } slotted_quad_t;

  // What is still to be computed of a quad, and where its planes are from.
  typedef struct packed {
    logic [1:0]  slot;
    logic [14:0] x;  // from the primitive's reference pixel
    logic [14:0] y;
    logic [47:0] attributes;
  } attribute_list_t;

  // Lanes' reciprocals.
  localparam int unsigned DivisorWidth = 128;

  // A quad whose attributes are on their way: `has_values` says that there are any.
  typedef struct packed {
    logic         has_values;
    logic         constant_color;
    logic         constant_secondary;
    logic [31:0]  color;
    logic [23:0]  secondary;
    logic [383:0] quad;
  } collected_quad_t;

  // A quad up to its samples: what shade_quad_t begins with.
  typedef struct packed {
    logic [383:0] quad;
    logic [127:0] primary;
    logic [95:0]  secondary;
    logic [127:0] fog_coordinate;
  } pending_quad_t;

  // A quad to be sampled by one unit. The coordinates stand as in level_quad_t.
  typedef struct packed {
    logic         tag;
    logic [31:0]  draw;
    logic         last_unit;  // of the quad
    logic [2:0]   unit;
    logic [3:0]   live;
    logic [383:0] coordinates;
  } sample_request_t;

  // All that a texture unit is told: registers, and what the front end made of the image's shape
  // once a draw, of each level {layer stride, row stride, offset} in bytes, level 0 lowest.
  typedef struct packed {
    logic [1535:0] levels;
    logic [95:0]   image;
    logic [191:0]  sampler;
  } texture_context_t;
  localparam int unsigned TextureContextWidth = 1824;

  // A texel on its way: where it is in its block, and which bank of contexts it is under.
  typedef struct packed {
    logic       bank;
    logic       is_border;
    logic [2:0] x;
    logic [1:0] y;
    logic [3:0] offset;  // in a block of 16 bytes
  } texel_note_t;
  typedef struct packed {
    texel_note_t note;
    logic        last;  // of its request
    logic [31:0] address;
  } fetched_texel_t;

  // A request's filter: filter_level_t without texels, and how many there are.
  typedef struct packed {
    logic [2:0]  last_texel;
    logic        tag;
    logic [9:0]  place;
    logic        last_level;
    logic        last_probe;
    logic [4:0]  probes;
    logic [31:0] weights;  // level, z, y, x
  } filter_note_t;

  // A surface in memory. Rows of four bytes a pixel or less; addresses and strides are multiples of
  // two pixels.
  typedef struct packed {
    logic [31:0] address;
    logic [31:0] stride;
  } surface_place_t;

  // What the pipe is told of a draw beside the contexts of texture units.
  typedef struct packed {
    logic [47:0]  carried;  // attributes that the draw's primitives have planes or colours of
    logic [7:0]   sampled_units;
    logic [767:0] combiners;  // words of combiner 0 lowest
    logic [31:0]  control;  // fragment_control
    logic [89:0]  fog;  // fog_curve_t
    logic [164:0] stencil_depth;  // stencil_depth_state_t
    logic [100:0] blend;  // blend_state_t
    logic [63:0]  depth_place;  // surface_place_t
    logic [63:0]  color_place;
  } draw_state_t;

  // Memory of targets: two words of 8 bytes, that of the quad's lower row lowest.
  typedef struct packed {
    logic [31:0] upper;  // addresses
    logic [31:0] lower;
  } target_request_t;
  typedef struct packed {
    target_request_t at;
    logic [15:0]     enables;  // of bytes
    logic [127:0]    data;
  } target_store_t;

  // Those that have to be interpolated.
  function automatic logic [47:0] varying(
    input logic [47:0] carried,
    input logic        constant_color,
    input logic        constant_secondary
  );
    varying = carried;
    if (constant_color) begin
      varying = varying & ~PrimaryMask;
    end
    if (constant_secondary) begin
      varying = varying & ~SecondaryMask;
    end
  endfunction

  // Of a pixel of a target, as a power of two.
  function automatic logic [1:0] pixel_bytes_log2(input logic [4:0] format);
    case (format)
      5'd1, 5'd2, 5'd17:                    pixel_bytes_log2 = 2'd2;
      5'd6, 5'd7, 5'd8, 5'd9, 5'd16:        pixel_bytes_log2 = 2'd1;
      default:                              pixel_bytes_log2 = 2'd0;
    endcase
  endfunction

endpackage
