// Types of the texture units, from coordinates to requests of texels. Floats are binary32; lanes are
// four, lane 0 lowest.
package ffgpu_texture_pkg;

  localparam int unsigned Lanes = 4;
  localparam int unsigned FloatWidth = 32;

  // A quad's texture coordinates, of a cube map on one of its faces: axis a of lane l is number
  // 3 l + a.
  typedef struct packed {
    logic                          tag;
    logic [9:0]                    place;
    logic                          one_face;  // No lane lies on another.
    logic [3*Lanes*FloatWidth-1:0] coordinates;
  } level_quad_t;

  // Inside level_of_detail: the coordinates' steps, and what is made of them. Axis a of side x is
  // number a, of side y 3 + a.
  typedef struct packed {
    logic                      tag;
    logic [9:0]                place;
    logic                      one_face;
    logic [2*3*FloatWidth-1:0] steps;
    logic [2*3*FloatWidth-1:0] values;
  } level_steps_t;

  typedef struct packed {
    logic [1:0]   is_used;  // the second axis, the third
    logic [38:0]  densities;  // texels for each unit of a coordinate, s lowest
    level_steps_t steps;
  } level_operands_t;

  // How a quad is sampled.
  typedef struct packed {
    logic                    tag;
    logic [9:0]              place;
    logic [3:0]              level;
    logic [3:0]              next_level;  // used if the weight is not 0
    logic [7:0]              weight;  // of the next level
    logic                    linear;  // within a level
    logic [4:0]              probes;  // 1 .. 16
    logic [3*FloatWidth-1:0] major_step;  // of the coordinates, over the pixel's longer side
  } quad_levels_t;

  // A quad whose texels are to be found: where its live lanes are, of cube maps on their faces.
  typedef struct packed {
    logic [Lanes-1:0]              live;
    logic [Lanes*3-1:0]            faces;
    logic [3*Lanes*FloatWidth-1:0] coordinates;  // as in level_quad_t
    quad_levels_t                  levels;
  } address_quad_t;

  // One level of one probe of a fragment, and where its texels are: for axis a the first at number
  // 2 a, the second above it. Axes count in the stored image, from its border if it has one; the
  // last is the slice or face.
  localparam int unsigned TexelPlaceWidth = 14;
  localparam int unsigned TexelPlaceBorder = 13;  // This bit: the border's colour stands for it.
  typedef struct packed {
    logic       tag;
    logic [9:0] place;
    logic [1:0] lane;
    logic [2:0] face;
    logic [3:0] level;
    logic       linear;
    logic       last_level;
    logic       last_probe;
    logic [4:0] probes;
    logic [4:0] probe;  // from 1
    logic [7:0] level_weight;  // of the coarser level
  } texel_header_t;
  typedef struct packed {
    texel_header_t                    header;
    logic [7:0]                       weight_z;  // of the second texel; 0 on an axis that is not
    logic [7:0]                       weight_y;  // filtered
    logic [7:0]                       weight_x;
    logic [3*2*TexelPlaceWidth-1:0]   places;
  } texel_request_t;

  // Inside texel_address: a number for each axis on its way from the coordinate to texels, and one
  // that the next step takes beside it.
  typedef struct packed {
    texel_header_t           header;
    logic [3*FloatWidth-1:0] values;
    logic [3*FloatWidth-1:0] others;
  } texel_walk_t;

  // How an axis of a level is addressed: a wrap mode as constants (ffgpu::WrapRule), and sizes in
  // texels.
  typedef struct packed {
    logic        is_rectangle;  // Coordinates count texels.
    logic [12:0] size;  // of level 0
    logic [12:0] level_size;
    logic [1:0]  fold;
    logic        wraps;  // An index past one edge comes in at the other.
    logic        border;  // Indices -1 and size mean border texels.
    logic [23:0] low;  // Signed, 8 fraction bits: texel coordinates are clamped to low ...
    logic [23:0] above;  // ... and to the size and above.
  } axis_rule_t;
  typedef struct packed {
    axis_rule_t  rule;
    texel_walk_t walk;
  } texel_operands_t;

  localparam logic [1:0] FoldRepeat = 2'd0;
  localparam logic [1:0] FoldMirror = 2'd1;
  localparam logic [1:0] FoldClamp = 2'd2;
  localparam logic [1:0] FoldMirrorClamp = 2'd3;

  // A block of 16 bytes that is wanted, and what stands there.
  typedef struct packed {
    logic        tag;
    logic [9:0]  place;
    logic [31:0] address;  // The lowest four bits do not matter.
  } texel_read_t;
  typedef struct packed {
    logic         tag;
    logic [9:0]   place;
    logic         missed;
    logic [127:0] block;
  } texel_data_t;

endpackage
