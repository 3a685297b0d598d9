// The registers and commands as packed structs, with a function each that decodes its words.
// Printed from the list in model/device/registers.h by the build target registers_page; not edited
// by hand. docs/registers.md says where each field stands, model/device/registers/ what it means.
//
// Of a register: its address (of the first where there are several in a row, then Count of them),
// its words and its packed reset value, word 0 lowest. Of a command: its opcode, the words of its
// payload. Fields stand in the structs in the order of the list, arrays with element 0 lowest.
package ffgpu_registers_pkg;

  typedef enum logic [1:0] {
    NormalModeKeep = 2'd0,
    NormalModeRescale = 2'd1,
    NormalModeNormalize = 2'd2
  } normal_mode_e;

  typedef enum logic [2:0] {
    TexGenModeOff = 3'd0,
    TexGenModeObjectLinear = 3'd1,
    TexGenModeEyeLinear = 3'd2,
    TexGenModeSphereMap = 3'd3,
    TexGenModeNormalMap = 3'd4,
    TexGenModeReflectionMap = 3'd5
  } tex_gen_mode_e;

  typedef enum logic [1:0] {
    PolygonModePoint = 2'd0,
    PolygonModeLine = 2'd1,
    PolygonModeFill = 2'd2
  } polygon_mode_e;

  typedef enum logic [2:0] {
    TextureKindNone = 3'd0,
    TextureKindOneD = 3'd1,
    TextureKindTwoD = 3'd2,
    TextureKindThreeD = 3'd3,
    TextureKindCube = 3'd4,
    TextureKindRectangle = 3'd5
  } texture_kind_e;

  typedef enum logic [4:0] {
    FormatNone = 5'd0,
    FormatRgba8 = 5'd1,
    FormatRgbx8 = 5'd2,
    FormatLuminance8 = 5'd3,
    FormatAlpha8 = 5'd4,
    FormatIntensity8 = 5'd5,
    FormatLuminanceAlpha8 = 5'd6,
    FormatRgb565 = 5'd7,
    FormatRgba4 = 5'd8,
    FormatRgb5a1 = 5'd9,
    FormatDxt1Rgb = 5'd10,
    FormatDxt1Rgba = 5'd11,
    FormatDxt3 = 5'd12,
    FormatDxt5 = 5'd13,
    FormatFxt1Rgb = 5'd14,
    FormatFxt1Rgba = 5'd15,
    FormatDepth16 = 5'd16,
    FormatDepth24Stencil8 = 5'd17,
    FormatStencil8 = 5'd18,
    FormatBitmap = 5'd19
  } format_e;

  typedef enum logic [2:0] {
    WrapRepeat = 3'd0,
    WrapMirroredRepeat = 3'd1,
    WrapClamp = 3'd2,
    WrapClampToEdge = 3'd3,
    WrapClampToBorder = 3'd4,
    WrapMirrorClamp = 3'd5,
    WrapMirrorClampToEdge = 3'd6,
    WrapMirrorClampToBorder = 3'd7
  } wrap_e;

  typedef enum logic [1:0] {
    MipFilterNone = 2'd0,
    MipFilterNearest = 2'd1,
    MipFilterLinear = 2'd2
  } mip_filter_e;

  typedef enum logic [2:0] {
    CompareNever = 3'd0,
    CompareLess = 3'd1,
    CompareEqual = 3'd2,
    CompareLequal = 3'd3,
    CompareGreater = 3'd4,
    CompareNotequal = 3'd5,
    CompareGequal = 3'd6,
    CompareAlways = 3'd7
  } compare_e;

  typedef enum logic [1:0] {
    DepthModeLuminance = 2'd0,
    DepthModeIntensity = 2'd1,
    DepthModeAlpha = 2'd2
  } depth_mode_e;

  typedef enum logic [2:0] {
    TextureFilterStandard = 3'd0,
    TextureFilterBicubic = 3'd1,
    TextureFilterRipMap = 3'd2,
    TextureFilterSummedArea = 3'd3,
    TextureFilterElliptic = 3'd4,
    TextureFilterFeline = 3'd5
  } texture_filter_e;

  typedef enum logic [3:0] {
    CombineOpReplace = 4'd0,
    CombineOpModulate = 4'd1,
    CombineOpAdd = 4'd2,
    CombineOpAddSigned = 4'd3,
    CombineOpInterpolate = 4'd4,
    CombineOpSubtract = 4'd5,
    CombineOpDot3Rgb = 4'd6,
    CombineOpDot3Rgba = 4'd7,
    CombineOpModulateAdd = 4'd8,
    CombineOpModulateSignedAdd = 4'd9,
    CombineOpModulateSubtract = 4'd10,
    CombineOpAddProducts = 4'd11,
    CombineOpAddProductsSigned = 4'd12
  } combine_op_e;

  typedef enum logic [3:0] {
    CombineSourceTexture0 = 4'd0,
    CombineSourceTexture1 = 4'd1,
    CombineSourceTexture2 = 4'd2,
    CombineSourceTexture3 = 4'd3,
    CombineSourceTexture4 = 4'd4,
    CombineSourceTexture5 = 4'd5,
    CombineSourceTexture6 = 4'd6,
    CombineSourceTexture7 = 4'd7,
    CombineSourceConstant = 4'd8,
    CombineSourcePrimary = 4'd9,
    CombineSourcePrevious = 4'd10,
    CombineSourceZero = 4'd11,
    CombineSourceOne = 4'd12
  } combine_source_e;

  typedef enum logic [1:0] {
    CombineOperandColor = 2'd0,
    CombineOperandOneMinusColor = 2'd1,
    CombineOperandAlpha = 2'd2,
    CombineOperandOneMinusAlpha = 2'd3
  } combine_operand_e;

  typedef enum logic [1:0] {
    FogModeOff = 2'd0,
    FogModeLinear = 2'd1,
    FogModeExp = 2'd2,
    FogModeExp2 = 2'd3
  } fog_mode_e;

  typedef enum logic [1:0] {
    FogCoordinateSourceEyeZ = 2'd0,
    FogCoordinateSourceEyeZSigned = 2'd1,
    FogCoordinateSourceEyeRadial = 2'd2,
    FogCoordinateSourceAttribute = 2'd3
  } fog_coordinate_source_e;

  typedef enum logic [2:0] {
    StencilOpKeep = 3'd0,
    StencilOpZero = 3'd1,
    StencilOpReplace = 3'd2,
    StencilOpIncrement = 3'd3,
    StencilOpDecrement = 3'd4,
    StencilOpInvert = 3'd5,
    StencilOpIncrementWrap = 3'd6,
    StencilOpDecrementWrap = 3'd7
  } stencil_op_e;

  typedef enum logic [3:0] {
    LogicOpClear = 4'd0,
    LogicOpAnd = 4'd1,
    LogicOpAndReverse = 4'd2,
    LogicOpCopy = 4'd3,
    LogicOpAndInverted = 4'd4,
    LogicOpNoop = 4'd5,
    LogicOpXor = 4'd6,
    LogicOpOr = 4'd7,
    LogicOpNor = 4'd8,
    LogicOpEquiv = 4'd9,
    LogicOpInvert = 4'd10,
    LogicOpOrReverse = 4'd11,
    LogicOpCopyInverted = 4'd12,
    LogicOpOrInverted = 4'd13,
    LogicOpNand = 4'd14,
    LogicOpSet = 4'd15
  } logic_op_e;

  typedef enum logic [2:0] {
    BlendEquationAdd = 3'd0,
    BlendEquationSubtract = 3'd1,
    BlendEquationReverseSubtract = 3'd2,
    BlendEquationMin = 3'd3,
    BlendEquationMax = 3'd4
  } blend_equation_e;

  typedef enum logic [3:0] {
    BlendFactorZero = 4'd0,
    BlendFactorOne = 4'd1,
    BlendFactorSourceColor = 4'd2,
    BlendFactorOneMinusSourceColor = 4'd3,
    BlendFactorDestinationColor = 4'd4,
    BlendFactorOneMinusDestinationColor = 4'd5,
    BlendFactorSourceAlpha = 4'd6,
    BlendFactorOneMinusSourceAlpha = 4'd7,
    BlendFactorDestinationAlpha = 4'd8,
    BlendFactorOneMinusDestinationAlpha = 4'd9,
    BlendFactorConstantColor = 4'd10,
    BlendFactorOneMinusConstantColor = 4'd11,
    BlendFactorConstantAlpha = 4'd12,
    BlendFactorOneMinusConstantAlpha = 4'd13,
    BlendFactorSourceAlphaSaturate = 4'd14
  } blend_factor_e;

  typedef enum logic [3:0] {
    PrimitiveTypePoints = 4'd0,
    PrimitiveTypeLines = 4'd1,
    PrimitiveTypeLineLoop = 4'd2,
    PrimitiveTypeLineStrip = 4'd3,
    PrimitiveTypeTriangles = 4'd4,
    PrimitiveTypeTriangleStrip = 4'd5,
    PrimitiveTypeTriangleFan = 4'd6,
    PrimitiveTypeQuads = 4'd7,
    PrimitiveTypeQuadStrip = 4'd8,
    PrimitiveTypePolygon = 4'd9
  } primitive_type_e;

  typedef enum logic [1:0] {
    IndexTypeNone = 2'd0,
    IndexTypeU16 = 2'd1,
    IndexTypeU32 = 2'd2
  } index_type_e;

  typedef enum logic {
    DrawOutputRaster = 1'd0,
    DrawOutputFeedback = 1'd1
  } draw_output_e;

  // Opcodes: bits 31..24 of a command's first word.
  localparam int unsigned WriteRegisterOpcode = 1;
  localparam int unsigned DrawOpcode = 2;
  localparam int unsigned ClearOpcode = 3;
  localparam int unsigned DrawImageOpcode = 4;
  localparam int unsigned CopyRectangleOpcode = 5;
  localparam int unsigned ResetSampleCounterOpcode = 6;
  localparam int unsigned StoreSampleCounterOpcode = 7;
  localparam int unsigned EndFrameOpcode = 8;

  // vertex_format
  localparam int unsigned VertexFormatAddress = 0;
  localparam int unsigned VertexFormatWords = 6;
  typedef logic [32*VertexFormatWords-1:0] vertex_format_words_t;
  typedef struct packed {
    logic [7:0] stride;
    logic [2:0] components_0;
    logic [7:0] offset_0;
    logic [2:0] components_1;
    logic [7:0] offset_1;
    logic [2:0] components_2;
    logic [7:0] offset_2;
    logic [2:0] components_3;
    logic [7:0] offset_3;
    logic [2:0] components_4;
    logic [7:0] offset_4;
    logic [2:0] components_5;
    logic [7:0] offset_5;
    logic [2:0] components_6;
    logic [7:0] offset_6;
    logic [2:0] components_7;
    logic [7:0] offset_7;
    logic [2:0] components_8;
    logic [7:0] offset_8;
    logic [2:0] components_9;
    logic [7:0] offset_9;
    logic [2:0] components_10;
    logic [7:0] offset_10;
    logic [2:0] components_11;
    logic [7:0] offset_11;
    logic [2:0] components_12;
    logic [7:0] offset_12;
    logic [2:0] components_13;
    logic [7:0] offset_13;
  } vertex_format_t;
  function automatic vertex_format_t decode_vertex_format(
    input vertex_format_words_t words
  );
    decode_vertex_format = {
      words[7:0],  // stride
      words[10:8],  // components_0
      words[18:11],  // offset_0
      words[21:19],  // components_1
      words[29:22],  // offset_1
      words[34:32],  // components_2
      words[42:35],  // offset_2
      words[45:43],  // components_3
      words[53:46],  // offset_3
      words[56:54],  // components_4
      words[71:64],  // offset_4
      words[74:72],  // components_5
      words[82:75],  // offset_5
      words[85:83],  // components_6
      words[93:86],  // offset_6
      words[98:96],  // components_7
      words[106:99],  // offset_7
      words[109:107],  // components_8
      words[117:110],  // offset_8
      words[120:118],  // components_9
      words[135:128],  // offset_9
      words[138:136],  // components_10
      words[146:139],  // offset_10
      words[149:147],  // components_11
      words[157:150],  // offset_11
      words[162:160],  // components_12
      words[170:163],  // offset_12
      words[173:171],  // components_13
      words[181:174]  // offset_13
    };
  endfunction
  localparam vertex_format_words_t VertexFormatReset = {
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000404
  };

  // current_attributes
  localparam int unsigned CurrentAttributesAddress = 1;
  localparam int unsigned CurrentAttributesWords = 56;
  typedef logic [32*CurrentAttributesWords-1:0] current_attributes_words_t;
  typedef struct packed {
    logic [55:0][31:0] value;
  } current_attributes_t;
  function automatic current_attributes_t decode_current_attributes(
    input current_attributes_words_t words
  );
    decode_current_attributes = {
      words[1791:0]  // value
    };
  endfunction
  localparam current_attributes_words_t CurrentAttributesReset = {
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h3f800000,
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f800000, 32'h3f800000, 32'h3f800000,
    32'h3f800000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000
  };

  // transform
  localparam int unsigned TransformAddress = 2;
  localparam int unsigned TransformWords = 43;
  typedef logic [32*TransformWords-1:0] transform_words_t;
  typedef struct packed {
    logic [15:0][31:0] model_view;
    logic [15:0][31:0] projection;
    logic [8:0][31:0]  normal_matrix;
    logic [31:0]       rescale;
    normal_mode_e      normal_mode;
  } transform_t;
  function automatic transform_t decode_transform(
    input transform_words_t words
  );
    decode_transform = {
      words[511:0],  // model_view
      words[1023:512],  // projection
      words[1311:1024],  // normal_matrix
      words[1343:1312],  // rescale
      words[1345:1344]  // normal_mode
    };
  endfunction
  localparam transform_words_t TransformReset = {
    32'h00000000, 32'h3f800000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h3f800000
  };

  // lighting
  localparam int unsigned LightingAddress = 3;
  localparam int unsigned LightingWords = 5;
  typedef logic [32*LightingWords-1:0] lighting_words_t;
  typedef struct packed {
    logic             enable;
    logic             two_sided;
    logic             local_viewer;
    logic             separate_specular;
    logic [3:0]       color_material_front;
    logic [3:0]       color_material_back;
    logic [3:0][31:0] scene_ambient;
  } lighting_t;
  function automatic lighting_t decode_lighting(
    input lighting_words_t words
  );
    decode_lighting = {
      words[0],  // enable
      words[1],  // two_sided
      words[2],  // local_viewer
      words[3],  // separate_specular
      words[7:4],  // color_material_front
      words[11:8],  // color_material_back
      words[159:32]  // scene_ambient
    };
  endfunction
  localparam lighting_words_t LightingReset = {
    32'h3f800000, 32'h3e4ccccd, 32'h3e4ccccd, 32'h3e4ccccd, 32'h00000000
  };

  // light
  localparam int unsigned LightAddress = 4;
  localparam int unsigned LightCount = 8;
  localparam int unsigned LightWords = 25;
  typedef logic [32*LightWords-1:0] light_words_t;
  typedef struct packed {
    logic             enable;
    logic [3:0][31:0] ambient;
    logic [3:0][31:0] diffuse;
    logic [3:0][31:0] specular;
    logic [3:0][31:0] position;
    logic [2:0][31:0] spot_direction;
    logic [31:0]      spot_exponent;
    logic [31:0]      spot_cutoff_cosine;
    logic [2:0][31:0] attenuation;
  } light_t;
  function automatic light_t decode_light(
    input light_words_t words
  );
    decode_light = {
      words[0],  // enable
      words[159:32],  // ambient
      words[287:160],  // diffuse
      words[415:288],  // specular
      words[543:416],  // position
      words[639:544],  // spot_direction
      words[671:640],  // spot_exponent
      words[703:672],  // spot_cutoff_cosine
      words[799:704]  // attenuation
    };
  endfunction
  localparam light_words_t LightReset = {
    32'h00000000, 32'h00000000, 32'h3f800000, 32'hbf800000, 32'h00000000, 32'hbf800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000
  };

  // material
  localparam int unsigned MaterialAddress = 12;
  localparam int unsigned MaterialCount = 2;
  localparam int unsigned MaterialWords = 17;
  typedef logic [32*MaterialWords-1:0] material_words_t;
  typedef struct packed {
    logic [3:0][31:0] ambient;
    logic [3:0][31:0] diffuse;
    logic [3:0][31:0] specular;
    logic [3:0][31:0] emission;
    logic [31:0]      shininess;
  } material_t;
  function automatic material_t decode_material(
    input material_words_t words
  );
    decode_material = {
      words[127:0],  // ambient
      words[255:128],  // diffuse
      words[383:256],  // specular
      words[511:384],  // emission
      words[543:512]  // shininess
    };
  endfunction
  localparam material_words_t MaterialReset = {
    32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f4ccccd, 32'h3f4ccccd,
    32'h3f4ccccd, 32'h3f800000, 32'h3e4ccccd, 32'h3e4ccccd, 32'h3e4ccccd
  };

  // tex_coord_setup
  localparam int unsigned TexCoordSetupAddress = 14;
  localparam int unsigned TexCoordSetupCount = 8;
  localparam int unsigned TexCoordSetupWords = 33;
  typedef logic [32*TexCoordSetupWords-1:0] tex_coord_setup_words_t;
  typedef struct packed {
    tex_gen_mode_e     mode_0;
    tex_gen_mode_e     mode_1;
    tex_gen_mode_e     mode_2;
    tex_gen_mode_e     mode_3;
    logic              matrix_enable;
    logic [15:0][31:0] plane;
    logic [15:0][31:0] matrix;
  } tex_coord_setup_t;
  function automatic tex_coord_setup_t decode_tex_coord_setup(
    input tex_coord_setup_words_t words
  );
    decode_tex_coord_setup = {
      words[2:0],  // mode_0
      words[5:3],  // mode_1
      words[8:6],  // mode_2
      words[11:9],  // mode_3
      words[12],  // matrix_enable
      words[543:32],  // plane
      words[1055:544]  // matrix
    };
  endfunction
  localparam tex_coord_setup_words_t TexCoordSetupReset = {
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000
  };

  // user_clip_planes
  localparam int unsigned UserClipPlanesAddress = 22;
  localparam int unsigned UserClipPlanesWords = 25;
  typedef logic [32*UserClipPlanesWords-1:0] user_clip_planes_words_t;
  typedef struct packed {
    logic [5:0]        enable;
    logic [23:0][31:0] plane;
  } user_clip_planes_t;
  function automatic user_clip_planes_t decode_user_clip_planes(
    input user_clip_planes_words_t words
  );
    decode_user_clip_planes = {
      words[5:0],  // enable
      words[799:32]  // plane
    };
  endfunction
  localparam user_clip_planes_words_t UserClipPlanesReset = {
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000
  };

  // viewport
  localparam int unsigned ViewportAddress = 23;
  localparam int unsigned ViewportWords = 7;
  typedef logic [32*ViewportWords-1:0] viewport_words_t;
  typedef struct packed {
    logic        clamp_depth;
    logic [31:0] x;
    logic [31:0] y;
    logic [31:0] width;
    logic [31:0] height;
    logic [31:0] near_depth;
    logic [31:0] far_depth;
  } viewport_t;
  function automatic viewport_t decode_viewport(
    input viewport_words_t words
  );
    decode_viewport = {
      words[0],  // clamp_depth
      words[63:32],  // x
      words[95:64],  // y
      words[127:96],  // width
      words[159:128],  // height
      words[191:160],  // near_depth
      words[223:192]  // far_depth
    };
  endfunction
  localparam viewport_words_t ViewportReset = {
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000
  };

  // primitive_setup
  localparam int unsigned PrimitiveSetupAddress = 24;
  localparam int unsigned PrimitiveSetupWords = 12;
  typedef logic [32*PrimitiveSetupWords-1:0] primitive_setup_words_t;
  typedef struct packed {
    logic             flat_shading;
    logic             front_is_clockwise;
    logic             cull_front;
    logic             cull_back;
    polygon_mode_e    front_mode;
    polygon_mode_e    back_mode;
    logic             offset_point;
    logic             offset_line;
    logic             offset_fill;
    logic             polygon_smooth;
    logic             polygon_stipple;
    logic             line_smooth;
    logic             line_stipple;
    logic             point_smooth;
    logic             point_sprite;
    logic             point_sprite_origin_lower_left;
    logic [7:0]       point_sprite_replace;
    logic [15:0]      line_stipple_pattern;
    logic [8:0]       line_stipple_factor;
    logic [31:0]      offset_factor;
    logic [31:0]      offset_units;
    logic [31:0]      line_width;
    logic [31:0]      point_size;
    logic [31:0]      point_size_min;
    logic [31:0]      point_size_max;
    logic [31:0]      point_fade_threshold;
    logic [2:0][31:0] point_attenuation;
  } primitive_setup_t;
  function automatic primitive_setup_t decode_primitive_setup(
    input primitive_setup_words_t words
  );
    decode_primitive_setup = {
      words[0],  // flat_shading
      words[1],  // front_is_clockwise
      words[2],  // cull_front
      words[3],  // cull_back
      words[5:4],  // front_mode
      words[7:6],  // back_mode
      words[8],  // offset_point
      words[9],  // offset_line
      words[10],  // offset_fill
      words[11],  // polygon_smooth
      words[12],  // polygon_stipple
      words[13],  // line_smooth
      words[14],  // line_stipple
      words[15],  // point_smooth
      words[16],  // point_sprite
      words[17],  // point_sprite_origin_lower_left
      words[25:18],  // point_sprite_replace
      words[47:32],  // line_stipple_pattern
      words[56:48],  // line_stipple_factor
      words[95:64],  // offset_factor
      words[127:96],  // offset_units
      words[159:128],  // line_width
      words[191:160],  // point_size
      words[223:192],  // point_size_min
      words[255:224],  // point_size_max
      words[287:256],  // point_fade_threshold
      words[383:288]  // point_attenuation
    };
  endfunction
  localparam primitive_setup_words_t PrimitiveSetupReset = {
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f800000, 32'h44800000, 32'h00000000,
    32'h3f800000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h0001ffff, 32'h000000a0
  };

  // polygon_stipple
  localparam int unsigned PolygonStippleAddress = 25;
  localparam int unsigned PolygonStippleWords = 32;
  typedef logic [32*PolygonStippleWords-1:0] polygon_stipple_words_t;
  typedef struct packed {
    logic [31:0][31:0] row;
  } polygon_stipple_t;
  function automatic polygon_stipple_t decode_polygon_stipple(
    input polygon_stipple_words_t words
  );
    decode_polygon_stipple = {
      words[1023:0]  // row
    };
  endfunction
  localparam polygon_stipple_words_t PolygonStippleReset = {
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff
  };

  // scissor
  localparam int unsigned ScissorAddress = 26;
  localparam int unsigned ScissorWords = 2;
  typedef logic [32*ScissorWords-1:0] scissor_words_t;
  typedef struct packed {
    logic [15:0] x;
    logic [15:0] y;
    logic [15:0] width;
    logic [15:0] height;
  } scissor_t;
  function automatic scissor_t decode_scissor(
    input scissor_words_t words
  );
    decode_scissor = {
      words[15:0],  // x
      words[31:16],  // y
      words[47:32],  // width
      words[63:48]  // height
    };
  endfunction
  localparam scissor_words_t ScissorReset = {
    32'h00000000, 32'h00000000
  };

  // texture_image
  localparam int unsigned TextureImageAddress = 27;
  localparam int unsigned TextureImageCount = 8;
  localparam int unsigned TextureImageWords = 3;
  typedef logic [32*TextureImageWords-1:0] texture_image_words_t;
  typedef struct packed {
    texture_kind_e kind;
    format_e       format;
    logic          border;
    logic [3:0]    levels;
    logic [12:0]   width;
    logic          srgb;
    logic [12:0]   height;
    logic [9:0]    depth;
    logic [31:0]   address;
  } texture_image_t;
  function automatic texture_image_t decode_texture_image(
    input texture_image_words_t words
  );
    decode_texture_image = {
      words[2:0],  // kind
      words[7:3],  // format
      words[8],  // border
      words[12:9],  // levels
      words[25:13],  // width
      words[26],  // srgb
      words[44:32],  // height
      words[54:45],  // depth
      words[95:64]  // address
    };
  endfunction
  localparam texture_image_words_t TextureImageReset = {
    32'h00000000, 32'h00002001, 32'h00000200
  };

  // sampler
  localparam int unsigned SamplerAddress = 35;
  localparam int unsigned SamplerCount = 8;
  localparam int unsigned SamplerWords = 6;
  typedef logic [32*SamplerWords-1:0] sampler_words_t;
  typedef struct packed {
    wrap_e           wrap_0;
    wrap_e           wrap_1;
    wrap_e           wrap_2;
    logic            magnify_linear;
    logic            minify_linear;
    mip_filter_e     mip_filter;
    logic [3:0]      base_level;
    logic [3:0]      max_level;
    logic [4:0]      max_anisotropy;
    logic            compare_enable;
    compare_e        compare;
    depth_mode_e     depth_mode;
    logic [15:0]     bias;
    logic [15:0]     min_lod;
    logic [15:0]     max_lod;
    logic [31:0]     border_color;
    logic [23:0]     border_depth;
    texture_filter_e filter;
    logic [12:0]     source_width;
    logic [12:0]     source_height;
  } sampler_t;
  function automatic sampler_t decode_sampler(
    input sampler_words_t words
  );
    decode_sampler = {
      words[2:0],  // wrap_0
      words[5:3],  // wrap_1
      words[8:6],  // wrap_2
      words[9],  // magnify_linear
      words[10],  // minify_linear
      words[12:11],  // mip_filter
      words[16:13],  // base_level
      words[20:17],  // max_level
      words[25:21],  // max_anisotropy
      words[26],  // compare_enable
      words[29:27],  // compare
      words[31:30],  // depth_mode
      words[47:32],  // bias
      words[63:48],  // min_lod
      words[79:64],  // max_lod
      words[127:96],  // border_color
      words[151:128],  // border_depth
      words[154:152],  // filter
      words[172:160],  // source_width
      words[185:173]  // source_height
    };
  endfunction
  localparam sampler_words_t SamplerReset = {
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00001000, 32'hf0000000, 32'h18381200
  };

  // combiner
  localparam int unsigned CombinerAddress = 43;
  localparam int unsigned CombinerCount = 8;
  localparam int unsigned CombinerWords = 3;
  typedef logic [32*CombinerWords-1:0] combiner_words_t;
  typedef struct packed {
    logic             enable;
    combine_op_e      rgb_op;
    logic [1:0]       rgb_scale_shift;
    combine_source_e  rgb_source_0;
    combine_operand_e rgb_operand_0;
    combine_source_e  rgb_source_1;
    combine_operand_e rgb_operand_1;
    combine_source_e  rgb_source_2;
    combine_operand_e rgb_operand_2;
    combine_source_e  rgb_source_3;
    combine_operand_e rgb_operand_3;
    combine_op_e      alpha_op;
    logic [1:0]       alpha_scale_shift;
    combine_source_e  alpha_source_0;
    combine_operand_e alpha_operand_0;
    combine_source_e  alpha_source_1;
    combine_operand_e alpha_operand_1;
    combine_source_e  alpha_source_2;
    combine_operand_e alpha_operand_2;
    combine_source_e  alpha_source_3;
    combine_operand_e alpha_operand_3;
    logic [31:0]      constant;
  } combiner_t;
  function automatic combiner_t decode_combiner(
    input combiner_words_t words
  );
    decode_combiner = {
      words[0],  // enable
      words[4:1],  // rgb_op
      words[6:5],  // rgb_scale_shift
      words[10:7],  // rgb_source_0
      words[12:11],  // rgb_operand_0
      words[16:13],  // rgb_source_1
      words[18:17],  // rgb_operand_1
      words[22:19],  // rgb_source_2
      words[24:23],  // rgb_operand_2
      words[28:25],  // rgb_source_3
      words[30:29],  // rgb_operand_3
      words[35:32],  // alpha_op
      words[37:36],  // alpha_scale_shift
      words[41:38],  // alpha_source_0
      words[43:42],  // alpha_operand_0
      words[47:44],  // alpha_source_1
      words[49:48],  // alpha_operand_1
      words[53:50],  // alpha_source_2
      words[55:54],  // alpha_operand_2
      words[59:56],  // alpha_source_3
      words[61:60],  // alpha_operand_3
      words[95:64]  // constant
    };
  endfunction
  localparam combiner_words_t CombinerReset = {
    32'h00000000, 32'h0a28a280, 32'h14514500
  };

  // fog
  localparam int unsigned FogAddress = 51;
  localparam int unsigned FogWords = 4;
  typedef logic [32*FogWords-1:0] fog_words_t;
  typedef struct packed {
    fog_mode_e              mode;
    fog_coordinate_source_e source;
    logic [23:0]            color;
    logic [31:0]            density;
    logic [31:0]            start;
    logic [31:0]            end_;
  } fog_t;
  function automatic fog_t decode_fog(
    input fog_words_t words
  );
    decode_fog = {
      words[1:0],  // mode
      words[3:2],  // source
      words[27:4],  // color
      words[63:32],  // density
      words[95:64],  // start
      words[127:96]  // end_
    };
  endfunction
  localparam fog_words_t FogReset = {
    32'h3f800000, 32'h00000000, 32'h3f800000, 32'h00000000
  };

  // fragment_control
  localparam int unsigned FragmentControlAddress = 52;
  localparam int unsigned FragmentControlWords = 1;
  typedef logic [32*FragmentControlWords-1:0] fragment_control_words_t;
  typedef struct packed {
    logic       color_sum;
    logic       alpha_test;
    compare_e   alpha_compare;
    logic [7:0] alpha_reference;
    logic       dither;
    logic       count_samples;
    logic [7:0] srgb_targets;
  } fragment_control_t;
  function automatic fragment_control_t decode_fragment_control(
    input fragment_control_words_t words
  );
    decode_fragment_control = {
      words[0],  // color_sum
      words[1],  // alpha_test
      words[4:2],  // alpha_compare
      words[12:5],  // alpha_reference
      words[13],  // dither
      words[14],  // count_samples
      words[22:15]  // srgb_targets
    };
  endfunction
  localparam fragment_control_words_t FragmentControlReset = {
    32'h0000201c
  };

  // stencil
  localparam int unsigned StencilAddress = 53;
  localparam int unsigned StencilWords = 3;
  typedef logic [32*StencilWords-1:0] stencil_words_t;
  typedef struct packed {
    logic        enable;
    compare_e    front_compare;
    stencil_op_e front_fail;
    stencil_op_e front_depth_fail;
    stencil_op_e front_depth_pass;
    logic [7:0]  front_reference;
    logic [7:0]  front_compare_mask;
    logic [7:0]  front_write_mask;
    compare_e    back_compare;
    stencil_op_e back_fail;
    stencil_op_e back_depth_fail;
    stencil_op_e back_depth_pass;
    logic [7:0]  back_reference;
    logic [7:0]  back_compare_mask;
    logic [7:0]  back_write_mask;
  } stencil_t;
  function automatic stencil_t decode_stencil(
    input stencil_words_t words
  );
    decode_stencil = {
      words[0],  // enable
      words[3:1],  // front_compare
      words[6:4],  // front_fail
      words[9:7],  // front_depth_fail
      words[12:10],  // front_depth_pass
      words[20:13],  // front_reference
      words[28:21],  // front_compare_mask
      words[39:32],  // front_write_mask
      words[42:40],  // back_compare
      words[45:43],  // back_fail
      words[48:46],  // back_depth_fail
      words[51:49],  // back_depth_pass
      words[59:52],  // back_reference
      words[71:64],  // back_compare_mask
      words[79:72]  // back_write_mask
    };
  endfunction
  localparam stencil_words_t StencilReset = {
    32'h0000ffff, 32'h000007ff, 32'h1fe0000e
  };

  // depth_control
  localparam int unsigned DepthControlAddress = 54;
  localparam int unsigned DepthControlWords = 2;
  typedef logic [32*DepthControlWords-1:0] depth_control_words_t;
  typedef struct packed {
    logic        test_enable;
    logic        write_enable;
    compare_e    compare;
    logic        bounds_enable;
    logic [23:0] bounds_min;
    logic [23:0] bounds_max;
  } depth_control_t;
  function automatic depth_control_t decode_depth_control(
    input depth_control_words_t words
  );
    decode_depth_control = {
      words[0],  // test_enable
      words[1],  // write_enable
      words[4:2],  // compare
      words[5],  // bounds_enable
      words[29:6],  // bounds_min
      words[55:32]  // bounds_max
    };
  endfunction
  localparam depth_control_words_t DepthControlReset = {
    32'h00ffffff, 32'h00000004
  };

  // blend
  localparam int unsigned BlendAddress = 55;
  localparam int unsigned BlendWords = 2;
  typedef logic [32*BlendWords-1:0] blend_words_t;
  typedef struct packed {
    logic            enable;
    logic            logic_op_enable;
    logic_op_e       logic_op;
    blend_equation_e rgb_equation;
    blend_equation_e alpha_equation;
    blend_factor_e   rgb_source;
    blend_factor_e   rgb_destination;
    blend_factor_e   alpha_source;
    blend_factor_e   alpha_destination;
    logic [3:0]      write_mask;
    logic [31:0]     constant;
  } blend_t;
  function automatic blend_t decode_blend(
    input blend_words_t words
  );
    decode_blend = {
      words[0],  // enable
      words[1],  // logic_op_enable
      words[5:2],  // logic_op
      words[8:6],  // rgb_equation
      words[11:9],  // alpha_equation
      words[15:12],  // rgb_source
      words[19:16],  // rgb_destination
      words[23:20],  // alpha_source
      words[27:24],  // alpha_destination
      words[31:28],  // write_mask
      words[63:32]  // constant
    };
  endfunction
  localparam blend_words_t BlendReset = {
    32'h00000000, 32'hf010100c
  };

  // multisample
  localparam int unsigned MultisampleAddress = 56;
  localparam int unsigned MultisampleWords = 1;
  typedef logic [32*MultisampleWords-1:0] multisample_words_t;
  typedef struct packed {
    logic       enable;
    logic       alpha_to_coverage;
    logic       alpha_to_one;
    logic [3:0] sample_mask;
  } multisample_t;
  function automatic multisample_t decode_multisample(
    input multisample_words_t words
  );
    decode_multisample = {
      words[0],  // enable
      words[1],  // alpha_to_coverage
      words[2],  // alpha_to_one
      words[6:3]  // sample_mask
    };
  endfunction
  localparam multisample_words_t MultisampleReset = {
    32'h00000078
  };

  // targets
  localparam int unsigned TargetsAddress = 57;
  localparam int unsigned TargetsWords = 36;
  typedef logic [32*TargetsWords-1:0] targets_words_t;
  typedef struct packed {
    logic [31:0] color_address_0;
    format_e     color_format_0;
    logic [12:0] color_width_0;
    logic [12:0] color_height_0;
    logic [31:0] color_stride_0;
    logic [2:0]  color_samples_0;
    logic [31:0] color_address_1;
    format_e     color_format_1;
    logic [12:0] color_width_1;
    logic [12:0] color_height_1;
    logic [31:0] color_stride_1;
    logic [2:0]  color_samples_1;
    logic [31:0] color_address_2;
    format_e     color_format_2;
    logic [12:0] color_width_2;
    logic [12:0] color_height_2;
    logic [31:0] color_stride_2;
    logic [2:0]  color_samples_2;
    logic [31:0] color_address_3;
    format_e     color_format_3;
    logic [12:0] color_width_3;
    logic [12:0] color_height_3;
    logic [31:0] color_stride_3;
    logic [2:0]  color_samples_3;
    logic [31:0] color_address_4;
    format_e     color_format_4;
    logic [12:0] color_width_4;
    logic [12:0] color_height_4;
    logic [31:0] color_stride_4;
    logic [2:0]  color_samples_4;
    logic [31:0] color_address_5;
    format_e     color_format_5;
    logic [12:0] color_width_5;
    logic [12:0] color_height_5;
    logic [31:0] color_stride_5;
    logic [2:0]  color_samples_5;
    logic [31:0] color_address_6;
    format_e     color_format_6;
    logic [12:0] color_width_6;
    logic [12:0] color_height_6;
    logic [31:0] color_stride_6;
    logic [2:0]  color_samples_6;
    logic [31:0] color_address_7;
    format_e     color_format_7;
    logic [12:0] color_width_7;
    logic [12:0] color_height_7;
    logic [31:0] color_stride_7;
    logic [2:0]  color_samples_7;
    logic [31:0] depth_address;
    format_e     depth_format;
    logic [12:0] depth_width;
    logic [12:0] depth_height;
    logic [31:0] depth_stride;
    logic [2:0]  depth_samples;
  } targets_t;
  function automatic targets_t decode_targets(
    input targets_words_t words
  );
    decode_targets = {
      words[31:0],  // color_address_0
      words[36:32],  // color_format_0
      words[49:37],  // color_width_0
      words[62:50],  // color_height_0
      words[95:64],  // color_stride_0
      words[98:96],  // color_samples_0
      words[159:128],  // color_address_1
      words[164:160],  // color_format_1
      words[177:165],  // color_width_1
      words[190:178],  // color_height_1
      words[223:192],  // color_stride_1
      words[226:224],  // color_samples_1
      words[287:256],  // color_address_2
      words[292:288],  // color_format_2
      words[305:293],  // color_width_2
      words[318:306],  // color_height_2
      words[351:320],  // color_stride_2
      words[354:352],  // color_samples_2
      words[415:384],  // color_address_3
      words[420:416],  // color_format_3
      words[433:421],  // color_width_3
      words[446:434],  // color_height_3
      words[479:448],  // color_stride_3
      words[482:480],  // color_samples_3
      words[543:512],  // color_address_4
      words[548:544],  // color_format_4
      words[561:549],  // color_width_4
      words[574:562],  // color_height_4
      words[607:576],  // color_stride_4
      words[610:608],  // color_samples_4
      words[671:640],  // color_address_5
      words[676:672],  // color_format_5
      words[689:677],  // color_width_5
      words[702:690],  // color_height_5
      words[735:704],  // color_stride_5
      words[738:736],  // color_samples_5
      words[799:768],  // color_address_6
      words[804:800],  // color_format_6
      words[817:805],  // color_width_6
      words[830:818],  // color_height_6
      words[863:832],  // color_stride_6
      words[866:864],  // color_samples_6
      words[927:896],  // color_address_7
      words[932:928],  // color_format_7
      words[945:933],  // color_width_7
      words[958:946],  // color_height_7
      words[991:960],  // color_stride_7
      words[994:992],  // color_samples_7
      words[1055:1024],  // depth_address
      words[1060:1056],  // depth_format
      words[1073:1061],  // depth_width
      words[1086:1074],  // depth_height
      words[1119:1088],  // depth_stride
      words[1122:1120]  // depth_samples
    };
  endfunction
  localparam targets_words_t TargetsReset = {
    32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000
  };

  // draw_command
  localparam int unsigned DrawCommandWords = 8;
  typedef logic [32*DrawCommandWords-1:0] draw_command_words_t;
  typedef struct packed {
    primitive_type_e primitive_;
    index_type_e     index_type;
    draw_output_e    output_;
    logic            continue_line_stipple;
    logic [31:0]     first;
    logic [31:0]     count;
    logic [31:0]     vertex_count;
    logic [31:0]     vertex_address;
    logic [31:0]     index_address;
    logic [31:0]     feedback_address;
    logic [31:0]     feedback_bytes;
  } draw_command_t;
  function automatic draw_command_t decode_draw_command(
    input draw_command_words_t words
  );
    decode_draw_command = {
      words[3:0],  // primitive_
      words[5:4],  // index_type
      words[6],  // output_
      words[7],  // continue_line_stipple
      words[63:32],  // first
      words[95:64],  // count
      words[127:96],  // vertex_count
      words[159:128],  // vertex_address
      words[191:160],  // index_address
      words[223:192],  // feedback_address
      words[255:224]  // feedback_bytes
    };
  endfunction

  // clear_command
  localparam int unsigned ClearCommandWords = 3;
  typedef logic [32*ClearCommandWords-1:0] clear_command_words_t;
  typedef struct packed {
    logic        color;
    logic        depth;
    logic        stencil;
    logic [7:0]  stencil_value;
    logic [31:0] color_value;
    logic [23:0] depth_value;
  } clear_command_t;
  function automatic clear_command_t decode_clear_command(
    input clear_command_words_t words
  );
    decode_clear_command = {
      words[0],  // color
      words[1],  // depth
      words[2],  // stencil
      words[10:3],  // stencil_value
      words[63:32],  // color_value
      words[87:64]  // depth_value
    };
  endfunction

  // draw_image_command
  localparam int unsigned DrawImageCommandWords = 51;
  typedef logic [32*DrawImageCommandWords-1:0] draw_image_command_words_t;
  typedef struct packed {
    format_e           format;
    logic [31:0]       address;
    logic [31:0]       stride;
    logic [31:0]       width;
    logic [31:0]       height;
    logic [31:0]       x;
    logic [31:0]       y;
    logic [31:0]       zoom_x;
    logic [31:0]       zoom_y;
    logic [31:0]       depth;
    logic [31:0]       fog_coordinate;
    logic [3:0][31:0]  color;
    logic [3:0][31:0]  secondary_color;
    logic [31:0][31:0] tex_coord;
  } draw_image_command_t;
  function automatic draw_image_command_t decode_draw_image_command(
    input draw_image_command_words_t words
  );
    decode_draw_image_command = {
      words[4:0],  // format
      words[63:32],  // address
      words[95:64],  // stride
      words[127:96],  // width
      words[159:128],  // height
      words[191:160],  // x
      words[223:192],  // y
      words[255:224],  // zoom_x
      words[287:256],  // zoom_y
      words[319:288],  // depth
      words[351:320],  // fog_coordinate
      words[479:352],  // color
      words[607:480],  // secondary_color
      words[1631:608]  // tex_coord
    };
  endfunction

  // copy_rectangle_command
  localparam int unsigned CopyRectangleCommandWords = 11;
  typedef logic [32*CopyRectangleCommandWords-1:0] copy_rectangle_command_words_t;
  typedef struct packed {
    logic [31:0] source_address;
    format_e     source_format;
    logic [12:0] source_width;
    logic [12:0] source_height;
    logic [31:0] source_stride;
    logic [2:0]  source_samples;
    logic [31:0] destination_address;
    format_e     destination_format;
    logic [12:0] destination_width;
    logic [12:0] destination_height;
    logic [31:0] destination_stride;
    logic [2:0]  destination_samples;
    logic [15:0] source_x;
    logic [15:0] source_y;
    logic [15:0] destination_x;
    logic [15:0] destination_y;
    logic [15:0] width;
    logic [15:0] height;
    logic [4:0]  pictures;
  } copy_rectangle_command_t;
  function automatic copy_rectangle_command_t decode_copy_rectangle_command(
    input copy_rectangle_command_words_t words
  );
    decode_copy_rectangle_command = {
      words[31:0],  // source_address
      words[36:32],  // source_format
      words[49:37],  // source_width
      words[62:50],  // source_height
      words[95:64],  // source_stride
      words[98:96],  // source_samples
      words[159:128],  // destination_address
      words[164:160],  // destination_format
      words[177:165],  // destination_width
      words[190:178],  // destination_height
      words[223:192],  // destination_stride
      words[226:224],  // destination_samples
      words[242:227],  // source_x
      words[271:256],  // source_y
      words[287:272],  // destination_x
      words[303:288],  // destination_y
      words[319:304],  // width
      words[335:320],  // height
      words[340:336]  // pictures
    };
  endfunction

  // store_sample_counter_command
  localparam int unsigned StoreSampleCounterCommandWords = 1;
  typedef logic [32*StoreSampleCounterCommandWords-1:0] store_sample_counter_command_words_t;
  typedef struct packed {
    logic [31:0] address;
  } store_sample_counter_command_t;
  function automatic store_sample_counter_command_t decode_store_sample_counter_command(
    input store_sample_counter_command_words_t words
  );
    decode_store_sample_counter_command = {
      words[31:0]  // address
    };
  endfunction

  // The fragment pipe in numbers: model/device/pipe_numbers.h.
  localparam int unsigned WalkerLatency = 1;  // cycles: tile_walker, from a quad's place to its output
  localparam int unsigned DepthPlaneLatency = 2;  // cycles
  localparam int unsigned AttributePlaneLatency = 2;  // cycles
  localparam int unsigned PerspectiveLatency = 4;  // cycles
  localparam int unsigned ReciprocalLatency = 6;  // cycles
  localparam int unsigned LevelOfDetailLatency = 6;  // cycles
  localparam int unsigned TexelAddressLatency = 9;  // cycles
  localparam int unsigned TexelFetchLatency = 1;  // cycles
  localparam int unsigned TexelCacheLatency = 2;  // cycles, where the line is there
  localparam int unsigned TexelDecodeLatency = 2;  // cycles
  localparam int unsigned FilterTreeLatency = 4;  // cycles
  localparam int unsigned TextureEnvironmentLatency = 3;  // cycles
  localparam int unsigned ColorSumLatency = 1;  // cycles
  localparam int unsigned FogLatency = 6;  // cycles
  localparam int unsigned ApplyCoverageLatency = 1;  // cycles
  localparam int unsigned AlphaTestLatency = 1;  // cycles
  localparam int unsigned QuadInterlockLatency = 1;  // cycles
  localparam int unsigned StencilDepthLatency = 1;  // cycles
  localparam int unsigned BlendLatency = 3;  // cycles
  localparam int unsigned TargetWriteLatency = 1;  // cycles: from a quad to its store's being offered
  localparam int unsigned FifoLatency = 1;  // cycles: a queue or a register
  localparam int unsigned WalkedQuads = 4;  // places: quads beside depth_plane
  localparam int unsigned DividedQuads = 8;  // places: quads whose divisors are made
  localparam int unsigned PendingQuads = 16;  // places: quads that wait for their samples
  localparam int unsigned TargetQuads = 16;  // places: quads between the read of a target and the store
  localparam int unsigned TexelQueue = 32;  // places: texels between tags and data
  localparam int unsigned CacheSetBits = 4;  // of the texel cache's sets
  localparam int unsigned CacheWayBits = 2;  // of its ways
  localparam int unsigned LineBits = 6;  // of the bytes of a line
  localparam int unsigned FillBits = 3;  // of lines on their way

endpackage
