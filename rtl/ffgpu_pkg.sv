// Types shared by every unit, and the arithmetic that several of them do. docs/rtl.md has the plan
// of the data: which unit fills which field.
//
// Vectors with a member a lane are flat, lane 0 lowest: lane l of W bits is [W*l +: W].
package ffgpu_pkg;

  localparam int unsigned Lanes = 4;  // of a quad: (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)
  localparam int unsigned TextureUnits = 8;

  localparam int unsigned ChannelWidth = 8;
  localparam int unsigned ColorWidth = 4 * ChannelWidth;  // rgba8, red lowest
  localparam int unsigned SecondaryWidth = 3 * ChannelWidth;
  localparam int unsigned DepthWidth = 24;
  localparam int unsigned PixelWidth = 32;  // of a target; narrower formats stand in the lower bits
  localparam int unsigned FloatWidth = 32;  // binary32

  typedef logic [ChannelWidth-1:0] channel_t;  // 8-bit unsigned normalised colour channel
  typedef logic [ChannelWidth-1:0] weight_t;   // 0.8 fixed point filter weight
  typedef logic [ColorWidth-1:0] color_t;
  typedef logic [PixelWidth-1:0] pixel_t;
  typedef logic [DepthWidth-1:0] depth_t;
  typedef logic [FloatWidth-1:0] float_t;

  // The name of a quad (model/packets/fragment_key.h): with its place, that of each fragment.
  typedef struct packed {
    logic [31:0] draw;
    logic [31:0] primitive_number;
    logic [31:0] piece;
  } quad_key_t;

  // A quad on its way from the tile walker to the targets.
  typedef struct packed {
    logic                          tag;  // of the draw: which bank of registers it is under
    quad_key_t                     key;
    logic [12:0]                   x;  // window pixel of lane 0, even
    logic [12:0]                   y;
    logic [Lanes-1:0]              live;  // covered, and not killed so far
    logic                          front_facing;
    logic [Lanes*DepthWidth-1:0]   depth;  // in units of the depth target
    logic [Lanes*ChannelWidth-1:0] coverage;  // of smooth primitives, 255 else
    logic [Lanes*ColorWidth-1:0]   color;  // the running colour; up to shading the primary one
  } quad_t;

  // A quad from the interpolator through the texture environments to fog.
  typedef struct packed {
    quad_t                                    quad;
    logic [Lanes*ColorWidth-1:0]              primary;
    logic [Lanes*SecondaryWidth-1:0]          secondary;  // red, green and blue
    logic [Lanes*FloatWidth-1:0]              fog_coordinate;
    logic [TextureUnits*Lanes*ColorWidth-1:0] samples;  // unit u, lane l: number 4 u + l
  } shade_quad_t;

  // A quad and what a target holds at its four pixels.
  typedef struct packed {
    quad_t                       quad;
    logic [Lanes*PixelWidth-1:0] pixels;
  } target_quad_t;

  // The same with what is to be stored. Bytes whose enable is 0 stay as they are; lanes without any
  // have no pixel.
  typedef struct packed {
    quad_t                       quad;
    logic [Lanes*PixelWidth-1:0] pixels;
    logic [Lanes*4-1:0]          enables;  // of the pixel's bytes
  } written_quad_t;

  // Inside blend: with the pixels' colours and the factors.
  typedef struct packed {
    quad_t                       quad;
    logic [Lanes*PixelWidth-1:0] pixels;
    logic [Lanes*ColorWidth-1:0] destination;
    logic [Lanes*ColorWidth-1:0] source_factors;
    logic [Lanes*ColorWidth-1:0] destination_factors;
  } factored_quad_t;

  // Inside texture_environment: four arguments a channel, channel c of lane l at 32 (4 l + c) with
  // argument 0 lowest; and results, twice the exact ones in units of 1 / 65025.
  localparam int unsigned DoubledWidth = 20;  // signed
  typedef struct packed {
    shade_quad_t                       shaded;
    logic [Lanes*4*4*ChannelWidth-1:0] arguments;
  } argument_quad_t;
  typedef struct packed {
    shade_quad_t                     shaded;
    logic [Lanes*4*DoubledWidth-1:0] doubled;
  } doubled_quad_t;

  // Inside fog: a number a lane, binary32 or an integer.
  typedef struct packed {
    quad_t                       quad;
    logic [Lanes*FloatWidth-1:0] values;
  } fog_quad_t;

  // A texel to be decoded, with what its unit's registers say of it.
  typedef struct packed {
    logic         tag;
    logic [9:0]   place;  // where its filter wants it
    logic         is_border;  // the block holds the border's colour or depth, lowest
    logic [4:0]   format;
    logic         srgb;
    logic         compare_enable;
    logic [2:0]   relation;
    logic [1:0]   depth_mode;
    logic [23:0]  depth_reference;  // to compare a depth with
    logic [2:0]   x;  // in the block
    logic [1:0]   y;
    logic [127:0] block;  // a texel, if the format has no blocks
  } texel_block_t;

  typedef struct packed {
    logic       tag;
    logic [9:0] place;
    color_t     color;
  } texel_t;

  // One level of one probe of a fragment, on its way through the filter. A fragment is one or more
  // probes, a probe one level or two, the finer first.
  typedef struct packed {
    logic         tag;
    logic [9:0]   place;
    logic         last_level;
    logic         last_probe;
    logic [4:0]   probes;  // 1 .. 16
    weight_t      level_weight;  // of the coarser level
    weight_t      weight_z;  // 0 on an axis that is not filtered
    weight_t      weight_y;
    weight_t      weight_x;
    logic [255:0] texels;  // number 4 z + 2 y + x
  } filter_level_t;

  // A number on its way through the divider.
  typedef struct packed {
    logic       tag;
    logic [9:0] place;
    float_t     value;
  } tagged_float_t;

  typedef struct packed {
    tagged_float_t item;
    logic [24:0]   remainder;
    logic [24:0]   quotient;
  } division_t;

  // A primitive's edges, its box and a tile. An edge is inside where a x + b y + c >= 0; box and
  // tile begin at a pixel, the box ends before (x1, y1).
  localparam int unsigned Edges = 4;
  localparam int unsigned EdgeStepWidth = 23;
  localparam int unsigned EdgeWidth = 45;
  typedef struct packed {
    logic                           tag;
    quad_key_t                      key;
    logic                           front_facing;
    logic [12:0]                    tile_x;
    logic [12:0]                    tile_y;
    logic [13:0]                    box_x0;
    logic [13:0]                    box_y0;
    logic [13:0]                    box_x1;
    logic [13:0]                    box_y1;
    logic [2:0]                     edge_count;
    logic [Edges*EdgeStepWidth-1:0] a;  // signed, as b and c
    logic [Edges*EdgeStepWidth-1:0] b;
    logic [Edges*EdgeWidth-1:0]     c;
  } tile_edges_t;

  typedef struct packed {
    logic             tag;
    quad_key_t        key;
    logic             front_facing;
    logic [12:0]      x;
    logic [12:0]      y;
    logic [Lanes-1:0] live;
  } covered_quad_t;

  // A quad and one attribute's plane (model/raster/attribute_plane.h), as stored_plane.h keeps it:
  // c with the half that rounds it, and steps, with 14 guard bits. x and y from the reference pixel.
  localparam int unsigned GuardBits = 14;
  typedef struct packed {
    logic                 tag;
    logic [9:0]           place;
    logic [14:0]          x;  // signed, as y, whole and the steps
    logic [14:0]          y;
    logic [31:0]          whole;  // of c + 1/2
    logic [GuardBits-1:0] fraction;
    logic [44:0]          dx;
    logic [44:0]          dy;
  } plane_quad_t;

  typedef struct packed {
    logic                tag;
    logic [9:0]          place;
    logic [Lanes*32-1:0] values;  // signed
  } lane_values_t;

  // Integers of an attribute at a quad's lanes, on their way to what they mean: times a factor a
  // lane (w, 1/q or 1), times 2^(scale - 127). Another kind is a coordinate.
  localparam logic [2:0] PerspectiveColor = 3'd1;
  localparam logic [2:0] PerspectiveFog = 3'd2;
  localparam logic [2:0] PerspectiveInverseW = 3'd3;  // at least `floor`
  localparam logic [2:0] PerspectiveQ = 3'd4;  // 1 for 0
  typedef struct packed {
    logic                        tag;
    logic [9:0]                  place;
    logic [2:0]                  kind;
    logic [31:0]                 floor;  // signed, as the values
    logic [7:0]                  scale;
    logic [Lanes*FloatWidth-1:0] factors;
    logic [Lanes*32-1:0]         values;  // on the way out binary32, of colours 0 .. 255
  } perspective_quad_t;

  // A quad and its primitive's depth plane: 24 fraction bits.
  typedef struct packed {
    logic        tag;
    logic [9:0]  place;
    logic [14:0] x;
    logic [14:0] y;
    logic [63:0] origin;
    logic [63:0] dx;
    logic [63:0] dy;
    depth_t      depth_min;
    depth_t      depth_max;
  } depth_plane_quad_t;

  typedef struct packed {
    logic                        tag;
    logic [9:0]                  place;
    logic [Lanes*DepthWidth-1:0] depths;
  } lane_depths_t;

  // Inside the two: products added up at the quad's corner.
  typedef struct packed {
    plane_quad_t quad;
    logic [45:0] corner;
  } plane_corner_t;
  typedef struct packed {
    depth_plane_quad_t quad;
    logic [63:0]       corner;
  } depth_corner_t;

  // (a (256 - weight) + b weight) / 256, rounded to nearest, halves up.
  function automatic channel_t lerp8w(
    input channel_t a,
    input channel_t b,
    input weight_t  weight
  );
    logic [16:0] rest;
    logic [16:0] sum;
    rest = 17'd256 - {9'd0, weight};
    sum = {9'd0, a} * rest + {9'd0, b} * {9'd0, weight} + 17'd128;
    lerp8w = sum[15:8];
  endfunction

  // What units are told: words of registers, which they decode, and what the front end made of
  // registers, once a draw. (yosys finds no other package's names in a struct: a wrong width shows
  // where the words are decoded.)
  typedef struct packed {
    logic [95:0] stencil;
    logic [63:0] depth;
    logic [4:0]  format;  // of the depth target; none: there is none
  } stencil_depth_state_t;

  typedef struct packed {
    logic [63:0] blend;
    logic [31:0] control;  // fragment_control
    logic [4:0]  format;  // of the colour target
  } blend_state_t;

  typedef struct packed {
    logic [95:0]             combiner;
    logic [TextureUnits-1:0] sampled_units;
  } texture_environment_state_t;

  // Of one texture unit.
  typedef struct packed {
    logic [95:0]  image;
    logic [191:0] sampler;
  } texture_state_t;

  // ffgpu::FogCurve: the coefficients that compile_fog() makes of the register.
  typedef struct packed {
    logic [1:0]  mode;
    float_t      end_coordinate;
    float_t      scale;
    logic [23:0] color;
  } fog_curve_t;

  // round(product / 255) for product <= 65025.
  function automatic channel_t divide_255(input logic [15:0] product);
    logic [15:0] biased;
    logic [15:0] sum;
    biased = product + 16'd128;
    sum = biased + {8'd0, biased[15:8]};
    divide_255 = sum[15:8];
  endfunction

  // floor(value / 255) for value < 65280, where it is a channel's.
  function automatic channel_t floor_255(input logic [15:0] value);
    logic [15:0] sum;
    sum = value + 16'd1 + {8'd0, value[15:8]};
    floor_255 = sum[15:8];
  endfunction

  // value (function) reference.
  function automatic logic compare(
    input logic [2:0] relation,  // compare_e
    input depth_t     value,
    input depth_t     reference
  );
    unique case (relation)
      ffgpu_registers_pkg::CompareNever:    compare = 1'b0;
      ffgpu_registers_pkg::CompareLess:     compare = value < reference;
      ffgpu_registers_pkg::CompareEqual:    compare = value == reference;
      ffgpu_registers_pkg::CompareLequal:   compare = value <= reference;
      ffgpu_registers_pkg::CompareGreater:  compare = value > reference;
      ffgpu_registers_pkg::CompareNotequal: compare = value != reference;
      ffgpu_registers_pkg::CompareGequal:   compare = value >= reference;
      ffgpu_registers_pkg::CompareAlways:   compare = 1'b1;
    endcase
  endfunction

endpackage
