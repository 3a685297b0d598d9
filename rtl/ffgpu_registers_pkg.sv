// Where each field of each register stands. Printed from the list in model/device/registers.h by
// the build target registers_page; not edited by hand. docs/registers.md says the same in a table.
//
// Of a register: its address (of the first where there are several in a row, then Count of them),
// its words and its packed reset value, word 0 lowest. Of a field: its word, least significant bit
// and width; Elements follow one another, a word each.
package ffgpu_registers_pkg;

  // vertex_format
  localparam int unsigned VertexFormatAddress = 0;
  localparam int unsigned VertexFormatWords = 6;
  localparam logic [191:0] VertexFormatReset = {
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000404
  };
  localparam int unsigned VertexFormatStrideWord = 0;
  localparam int unsigned VertexFormatStrideLsb = 0;
  localparam int unsigned VertexFormatStrideWidth = 8;
  localparam int unsigned VertexFormatComponents0Word = 0;
  localparam int unsigned VertexFormatComponents0Lsb = 8;
  localparam int unsigned VertexFormatComponents0Width = 3;
  localparam int unsigned VertexFormatOffset0Word = 0;
  localparam int unsigned VertexFormatOffset0Lsb = 11;
  localparam int unsigned VertexFormatOffset0Width = 8;
  localparam int unsigned VertexFormatComponents1Word = 0;
  localparam int unsigned VertexFormatComponents1Lsb = 19;
  localparam int unsigned VertexFormatComponents1Width = 3;
  localparam int unsigned VertexFormatOffset1Word = 0;
  localparam int unsigned VertexFormatOffset1Lsb = 22;
  localparam int unsigned VertexFormatOffset1Width = 8;
  localparam int unsigned VertexFormatComponents2Word = 1;
  localparam int unsigned VertexFormatComponents2Lsb = 0;
  localparam int unsigned VertexFormatComponents2Width = 3;
  localparam int unsigned VertexFormatOffset2Word = 1;
  localparam int unsigned VertexFormatOffset2Lsb = 3;
  localparam int unsigned VertexFormatOffset2Width = 8;
  localparam int unsigned VertexFormatComponents3Word = 1;
  localparam int unsigned VertexFormatComponents3Lsb = 11;
  localparam int unsigned VertexFormatComponents3Width = 3;
  localparam int unsigned VertexFormatOffset3Word = 1;
  localparam int unsigned VertexFormatOffset3Lsb = 14;
  localparam int unsigned VertexFormatOffset3Width = 8;
  localparam int unsigned VertexFormatComponents4Word = 1;
  localparam int unsigned VertexFormatComponents4Lsb = 22;
  localparam int unsigned VertexFormatComponents4Width = 3;
  localparam int unsigned VertexFormatOffset4Word = 2;
  localparam int unsigned VertexFormatOffset4Lsb = 0;
  localparam int unsigned VertexFormatOffset4Width = 8;
  localparam int unsigned VertexFormatComponents5Word = 2;
  localparam int unsigned VertexFormatComponents5Lsb = 8;
  localparam int unsigned VertexFormatComponents5Width = 3;
  localparam int unsigned VertexFormatOffset5Word = 2;
  localparam int unsigned VertexFormatOffset5Lsb = 11;
  localparam int unsigned VertexFormatOffset5Width = 8;
  localparam int unsigned VertexFormatComponents6Word = 2;
  localparam int unsigned VertexFormatComponents6Lsb = 19;
  localparam int unsigned VertexFormatComponents6Width = 3;
  localparam int unsigned VertexFormatOffset6Word = 2;
  localparam int unsigned VertexFormatOffset6Lsb = 22;
  localparam int unsigned VertexFormatOffset6Width = 8;
  localparam int unsigned VertexFormatComponents7Word = 3;
  localparam int unsigned VertexFormatComponents7Lsb = 0;
  localparam int unsigned VertexFormatComponents7Width = 3;
  localparam int unsigned VertexFormatOffset7Word = 3;
  localparam int unsigned VertexFormatOffset7Lsb = 3;
  localparam int unsigned VertexFormatOffset7Width = 8;
  localparam int unsigned VertexFormatComponents8Word = 3;
  localparam int unsigned VertexFormatComponents8Lsb = 11;
  localparam int unsigned VertexFormatComponents8Width = 3;
  localparam int unsigned VertexFormatOffset8Word = 3;
  localparam int unsigned VertexFormatOffset8Lsb = 14;
  localparam int unsigned VertexFormatOffset8Width = 8;
  localparam int unsigned VertexFormatComponents9Word = 3;
  localparam int unsigned VertexFormatComponents9Lsb = 22;
  localparam int unsigned VertexFormatComponents9Width = 3;
  localparam int unsigned VertexFormatOffset9Word = 4;
  localparam int unsigned VertexFormatOffset9Lsb = 0;
  localparam int unsigned VertexFormatOffset9Width = 8;
  localparam int unsigned VertexFormatComponents10Word = 4;
  localparam int unsigned VertexFormatComponents10Lsb = 8;
  localparam int unsigned VertexFormatComponents10Width = 3;
  localparam int unsigned VertexFormatOffset10Word = 4;
  localparam int unsigned VertexFormatOffset10Lsb = 11;
  localparam int unsigned VertexFormatOffset10Width = 8;
  localparam int unsigned VertexFormatComponents11Word = 4;
  localparam int unsigned VertexFormatComponents11Lsb = 19;
  localparam int unsigned VertexFormatComponents11Width = 3;
  localparam int unsigned VertexFormatOffset11Word = 4;
  localparam int unsigned VertexFormatOffset11Lsb = 22;
  localparam int unsigned VertexFormatOffset11Width = 8;
  localparam int unsigned VertexFormatComponents12Word = 5;
  localparam int unsigned VertexFormatComponents12Lsb = 0;
  localparam int unsigned VertexFormatComponents12Width = 3;
  localparam int unsigned VertexFormatOffset12Word = 5;
  localparam int unsigned VertexFormatOffset12Lsb = 3;
  localparam int unsigned VertexFormatOffset12Width = 8;
  localparam int unsigned VertexFormatComponents13Word = 5;
  localparam int unsigned VertexFormatComponents13Lsb = 11;
  localparam int unsigned VertexFormatComponents13Width = 3;
  localparam int unsigned VertexFormatOffset13Word = 5;
  localparam int unsigned VertexFormatOffset13Lsb = 14;
  localparam int unsigned VertexFormatOffset13Width = 8;

  // current_attributes
  localparam int unsigned CurrentAttributesAddress = 1;
  localparam int unsigned CurrentAttributesWords = 56;
  localparam logic [1791:0] CurrentAttributesReset = {
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
  localparam int unsigned CurrentAttributesValueWord = 0;
  localparam int unsigned CurrentAttributesValueLsb = 0;
  localparam int unsigned CurrentAttributesValueWidth = 32;
  localparam int unsigned CurrentAttributesValueElements = 56;

  // transform
  localparam int unsigned TransformAddress = 2;
  localparam int unsigned TransformWords = 43;
  localparam logic [1375:0] TransformReset = {
    32'h00000000, 32'h3f800000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h3f800000
  };
  localparam int unsigned TransformModelViewWord = 0;
  localparam int unsigned TransformModelViewLsb = 0;
  localparam int unsigned TransformModelViewWidth = 32;
  localparam int unsigned TransformModelViewElements = 16;
  localparam int unsigned TransformProjectionWord = 16;
  localparam int unsigned TransformProjectionLsb = 0;
  localparam int unsigned TransformProjectionWidth = 32;
  localparam int unsigned TransformProjectionElements = 16;
  localparam int unsigned TransformNormalMatrixWord = 32;
  localparam int unsigned TransformNormalMatrixLsb = 0;
  localparam int unsigned TransformNormalMatrixWidth = 32;
  localparam int unsigned TransformNormalMatrixElements = 9;
  localparam int unsigned TransformRescaleWord = 41;
  localparam int unsigned TransformRescaleLsb = 0;
  localparam int unsigned TransformRescaleWidth = 32;
  localparam int unsigned TransformNormalModeWord = 42;
  localparam int unsigned TransformNormalModeLsb = 0;
  localparam int unsigned TransformNormalModeWidth = 2;

  // lighting
  localparam int unsigned LightingAddress = 3;
  localparam int unsigned LightingWords = 5;
  localparam logic [159:0] LightingReset = {
    32'h3f800000, 32'h3e4ccccd, 32'h3e4ccccd, 32'h3e4ccccd, 32'h00000000
  };
  localparam int unsigned LightingEnableWord = 0;
  localparam int unsigned LightingEnableLsb = 0;
  localparam int unsigned LightingEnableWidth = 1;
  localparam int unsigned LightingTwoSidedWord = 0;
  localparam int unsigned LightingTwoSidedLsb = 1;
  localparam int unsigned LightingTwoSidedWidth = 1;
  localparam int unsigned LightingLocalViewerWord = 0;
  localparam int unsigned LightingLocalViewerLsb = 2;
  localparam int unsigned LightingLocalViewerWidth = 1;
  localparam int unsigned LightingSeparateSpecularWord = 0;
  localparam int unsigned LightingSeparateSpecularLsb = 3;
  localparam int unsigned LightingSeparateSpecularWidth = 1;
  localparam int unsigned LightingColorMaterialFrontWord = 0;
  localparam int unsigned LightingColorMaterialFrontLsb = 4;
  localparam int unsigned LightingColorMaterialFrontWidth = 4;
  localparam int unsigned LightingColorMaterialBackWord = 0;
  localparam int unsigned LightingColorMaterialBackLsb = 8;
  localparam int unsigned LightingColorMaterialBackWidth = 4;
  localparam int unsigned LightingSceneAmbientWord = 1;
  localparam int unsigned LightingSceneAmbientLsb = 0;
  localparam int unsigned LightingSceneAmbientWidth = 32;
  localparam int unsigned LightingSceneAmbientElements = 4;

  // light
  localparam int unsigned LightAddress = 4;
  localparam int unsigned LightCount = 8;
  localparam int unsigned LightWords = 25;
  localparam logic [799:0] LightReset = {
    32'h00000000, 32'h00000000, 32'h3f800000, 32'hbf800000, 32'h00000000, 32'hbf800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000
  };
  localparam int unsigned LightEnableWord = 0;
  localparam int unsigned LightEnableLsb = 0;
  localparam int unsigned LightEnableWidth = 1;
  localparam int unsigned LightAmbientWord = 1;
  localparam int unsigned LightAmbientLsb = 0;
  localparam int unsigned LightAmbientWidth = 32;
  localparam int unsigned LightAmbientElements = 4;
  localparam int unsigned LightDiffuseWord = 5;
  localparam int unsigned LightDiffuseLsb = 0;
  localparam int unsigned LightDiffuseWidth = 32;
  localparam int unsigned LightDiffuseElements = 4;
  localparam int unsigned LightSpecularWord = 9;
  localparam int unsigned LightSpecularLsb = 0;
  localparam int unsigned LightSpecularWidth = 32;
  localparam int unsigned LightSpecularElements = 4;
  localparam int unsigned LightPositionWord = 13;
  localparam int unsigned LightPositionLsb = 0;
  localparam int unsigned LightPositionWidth = 32;
  localparam int unsigned LightPositionElements = 4;
  localparam int unsigned LightSpotDirectionWord = 17;
  localparam int unsigned LightSpotDirectionLsb = 0;
  localparam int unsigned LightSpotDirectionWidth = 32;
  localparam int unsigned LightSpotDirectionElements = 3;
  localparam int unsigned LightSpotExponentWord = 20;
  localparam int unsigned LightSpotExponentLsb = 0;
  localparam int unsigned LightSpotExponentWidth = 32;
  localparam int unsigned LightSpotCutoffCosineWord = 21;
  localparam int unsigned LightSpotCutoffCosineLsb = 0;
  localparam int unsigned LightSpotCutoffCosineWidth = 32;
  localparam int unsigned LightAttenuationWord = 22;
  localparam int unsigned LightAttenuationLsb = 0;
  localparam int unsigned LightAttenuationWidth = 32;
  localparam int unsigned LightAttenuationElements = 3;

  // material
  localparam int unsigned MaterialAddress = 12;
  localparam int unsigned MaterialCount = 2;
  localparam int unsigned MaterialWords = 17;
  localparam logic [543:0] MaterialReset = {
    32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f4ccccd, 32'h3f4ccccd,
    32'h3f4ccccd, 32'h3f800000, 32'h3e4ccccd, 32'h3e4ccccd, 32'h3e4ccccd
  };
  localparam int unsigned MaterialAmbientWord = 0;
  localparam int unsigned MaterialAmbientLsb = 0;
  localparam int unsigned MaterialAmbientWidth = 32;
  localparam int unsigned MaterialAmbientElements = 4;
  localparam int unsigned MaterialDiffuseWord = 4;
  localparam int unsigned MaterialDiffuseLsb = 0;
  localparam int unsigned MaterialDiffuseWidth = 32;
  localparam int unsigned MaterialDiffuseElements = 4;
  localparam int unsigned MaterialSpecularWord = 8;
  localparam int unsigned MaterialSpecularLsb = 0;
  localparam int unsigned MaterialSpecularWidth = 32;
  localparam int unsigned MaterialSpecularElements = 4;
  localparam int unsigned MaterialEmissionWord = 12;
  localparam int unsigned MaterialEmissionLsb = 0;
  localparam int unsigned MaterialEmissionWidth = 32;
  localparam int unsigned MaterialEmissionElements = 4;
  localparam int unsigned MaterialShininessWord = 16;
  localparam int unsigned MaterialShininessLsb = 0;
  localparam int unsigned MaterialShininessWidth = 32;

  // tex_coord_setup
  localparam int unsigned TexCoordSetupAddress = 14;
  localparam int unsigned TexCoordSetupCount = 8;
  localparam int unsigned TexCoordSetupWords = 33;
  localparam logic [1055:0] TexCoordSetupReset = {
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h3f800000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000
  };
  localparam int unsigned TexCoordSetupMode0Word = 0;
  localparam int unsigned TexCoordSetupMode0Lsb = 0;
  localparam int unsigned TexCoordSetupMode0Width = 3;
  localparam int unsigned TexCoordSetupMode1Word = 0;
  localparam int unsigned TexCoordSetupMode1Lsb = 3;
  localparam int unsigned TexCoordSetupMode1Width = 3;
  localparam int unsigned TexCoordSetupMode2Word = 0;
  localparam int unsigned TexCoordSetupMode2Lsb = 6;
  localparam int unsigned TexCoordSetupMode2Width = 3;
  localparam int unsigned TexCoordSetupMode3Word = 0;
  localparam int unsigned TexCoordSetupMode3Lsb = 9;
  localparam int unsigned TexCoordSetupMode3Width = 3;
  localparam int unsigned TexCoordSetupMatrixEnableWord = 0;
  localparam int unsigned TexCoordSetupMatrixEnableLsb = 12;
  localparam int unsigned TexCoordSetupMatrixEnableWidth = 1;
  localparam int unsigned TexCoordSetupPlaneWord = 1;
  localparam int unsigned TexCoordSetupPlaneLsb = 0;
  localparam int unsigned TexCoordSetupPlaneWidth = 32;
  localparam int unsigned TexCoordSetupPlaneElements = 16;
  localparam int unsigned TexCoordSetupMatrixWord = 17;
  localparam int unsigned TexCoordSetupMatrixLsb = 0;
  localparam int unsigned TexCoordSetupMatrixWidth = 32;
  localparam int unsigned TexCoordSetupMatrixElements = 16;

  // user_clip_planes
  localparam int unsigned UserClipPlanesAddress = 22;
  localparam int unsigned UserClipPlanesWords = 25;
  localparam logic [799:0] UserClipPlanesReset = {
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000000
  };
  localparam int unsigned UserClipPlanesEnableWord = 0;
  localparam int unsigned UserClipPlanesEnableLsb = 0;
  localparam int unsigned UserClipPlanesEnableWidth = 6;
  localparam int unsigned UserClipPlanesPlaneWord = 1;
  localparam int unsigned UserClipPlanesPlaneLsb = 0;
  localparam int unsigned UserClipPlanesPlaneWidth = 32;
  localparam int unsigned UserClipPlanesPlaneElements = 24;

  // viewport
  localparam int unsigned ViewportAddress = 23;
  localparam int unsigned ViewportWords = 6;
  localparam logic [191:0] ViewportReset = {
    32'h3f800000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000000
  };
  localparam int unsigned ViewportXWord = 0;
  localparam int unsigned ViewportXLsb = 0;
  localparam int unsigned ViewportXWidth = 32;
  localparam int unsigned ViewportYWord = 1;
  localparam int unsigned ViewportYLsb = 0;
  localparam int unsigned ViewportYWidth = 32;
  localparam int unsigned ViewportWidthWord = 2;
  localparam int unsigned ViewportWidthLsb = 0;
  localparam int unsigned ViewportWidthWidth = 32;
  localparam int unsigned ViewportHeightWord = 3;
  localparam int unsigned ViewportHeightLsb = 0;
  localparam int unsigned ViewportHeightWidth = 32;
  localparam int unsigned ViewportNearDepthWord = 4;
  localparam int unsigned ViewportNearDepthLsb = 0;
  localparam int unsigned ViewportNearDepthWidth = 32;
  localparam int unsigned ViewportFarDepthWord = 5;
  localparam int unsigned ViewportFarDepthLsb = 0;
  localparam int unsigned ViewportFarDepthWidth = 32;

  // primitive_setup
  localparam int unsigned PrimitiveSetupAddress = 24;
  localparam int unsigned PrimitiveSetupWords = 12;
  localparam logic [383:0] PrimitiveSetupReset = {
    32'h00000000, 32'h00000000, 32'h3f800000, 32'h3f800000, 32'h44800000, 32'h00000000,
    32'h3f800000, 32'h3f800000, 32'h00000000, 32'h00000000, 32'h0001ffff, 32'h000000a0
  };
  localparam int unsigned PrimitiveSetupFlatShadingWord = 0;
  localparam int unsigned PrimitiveSetupFlatShadingLsb = 0;
  localparam int unsigned PrimitiveSetupFlatShadingWidth = 1;
  localparam int unsigned PrimitiveSetupFrontIsClockwiseWord = 0;
  localparam int unsigned PrimitiveSetupFrontIsClockwiseLsb = 1;
  localparam int unsigned PrimitiveSetupFrontIsClockwiseWidth = 1;
  localparam int unsigned PrimitiveSetupCullFrontWord = 0;
  localparam int unsigned PrimitiveSetupCullFrontLsb = 2;
  localparam int unsigned PrimitiveSetupCullFrontWidth = 1;
  localparam int unsigned PrimitiveSetupCullBackWord = 0;
  localparam int unsigned PrimitiveSetupCullBackLsb = 3;
  localparam int unsigned PrimitiveSetupCullBackWidth = 1;
  localparam int unsigned PrimitiveSetupFrontModeWord = 0;
  localparam int unsigned PrimitiveSetupFrontModeLsb = 4;
  localparam int unsigned PrimitiveSetupFrontModeWidth = 2;
  localparam int unsigned PrimitiveSetupBackModeWord = 0;
  localparam int unsigned PrimitiveSetupBackModeLsb = 6;
  localparam int unsigned PrimitiveSetupBackModeWidth = 2;
  localparam int unsigned PrimitiveSetupOffsetPointWord = 0;
  localparam int unsigned PrimitiveSetupOffsetPointLsb = 8;
  localparam int unsigned PrimitiveSetupOffsetPointWidth = 1;
  localparam int unsigned PrimitiveSetupOffsetLineWord = 0;
  localparam int unsigned PrimitiveSetupOffsetLineLsb = 9;
  localparam int unsigned PrimitiveSetupOffsetLineWidth = 1;
  localparam int unsigned PrimitiveSetupOffsetFillWord = 0;
  localparam int unsigned PrimitiveSetupOffsetFillLsb = 10;
  localparam int unsigned PrimitiveSetupOffsetFillWidth = 1;
  localparam int unsigned PrimitiveSetupPolygonSmoothWord = 0;
  localparam int unsigned PrimitiveSetupPolygonSmoothLsb = 11;
  localparam int unsigned PrimitiveSetupPolygonSmoothWidth = 1;
  localparam int unsigned PrimitiveSetupPolygonStippleWord = 0;
  localparam int unsigned PrimitiveSetupPolygonStippleLsb = 12;
  localparam int unsigned PrimitiveSetupPolygonStippleWidth = 1;
  localparam int unsigned PrimitiveSetupLineSmoothWord = 0;
  localparam int unsigned PrimitiveSetupLineSmoothLsb = 13;
  localparam int unsigned PrimitiveSetupLineSmoothWidth = 1;
  localparam int unsigned PrimitiveSetupLineStippleWord = 0;
  localparam int unsigned PrimitiveSetupLineStippleLsb = 14;
  localparam int unsigned PrimitiveSetupLineStippleWidth = 1;
  localparam int unsigned PrimitiveSetupPointSmoothWord = 0;
  localparam int unsigned PrimitiveSetupPointSmoothLsb = 15;
  localparam int unsigned PrimitiveSetupPointSmoothWidth = 1;
  localparam int unsigned PrimitiveSetupPointSpriteWord = 0;
  localparam int unsigned PrimitiveSetupPointSpriteLsb = 16;
  localparam int unsigned PrimitiveSetupPointSpriteWidth = 1;
  localparam int unsigned PrimitiveSetupPointSpriteOriginLowerLeftWord = 0;
  localparam int unsigned PrimitiveSetupPointSpriteOriginLowerLeftLsb = 17;
  localparam int unsigned PrimitiveSetupPointSpriteOriginLowerLeftWidth = 1;
  localparam int unsigned PrimitiveSetupPointSpriteReplaceWord = 0;
  localparam int unsigned PrimitiveSetupPointSpriteReplaceLsb = 18;
  localparam int unsigned PrimitiveSetupPointSpriteReplaceWidth = 8;
  localparam int unsigned PrimitiveSetupLineStipplePatternWord = 1;
  localparam int unsigned PrimitiveSetupLineStipplePatternLsb = 0;
  localparam int unsigned PrimitiveSetupLineStipplePatternWidth = 16;
  localparam int unsigned PrimitiveSetupLineStippleFactorWord = 1;
  localparam int unsigned PrimitiveSetupLineStippleFactorLsb = 16;
  localparam int unsigned PrimitiveSetupLineStippleFactorWidth = 9;
  localparam int unsigned PrimitiveSetupOffsetFactorWord = 2;
  localparam int unsigned PrimitiveSetupOffsetFactorLsb = 0;
  localparam int unsigned PrimitiveSetupOffsetFactorWidth = 32;
  localparam int unsigned PrimitiveSetupOffsetUnitsWord = 3;
  localparam int unsigned PrimitiveSetupOffsetUnitsLsb = 0;
  localparam int unsigned PrimitiveSetupOffsetUnitsWidth = 32;
  localparam int unsigned PrimitiveSetupLineWidthWord = 4;
  localparam int unsigned PrimitiveSetupLineWidthLsb = 0;
  localparam int unsigned PrimitiveSetupLineWidthWidth = 32;
  localparam int unsigned PrimitiveSetupPointSizeWord = 5;
  localparam int unsigned PrimitiveSetupPointSizeLsb = 0;
  localparam int unsigned PrimitiveSetupPointSizeWidth = 32;
  localparam int unsigned PrimitiveSetupPointSizeMinWord = 6;
  localparam int unsigned PrimitiveSetupPointSizeMinLsb = 0;
  localparam int unsigned PrimitiveSetupPointSizeMinWidth = 32;
  localparam int unsigned PrimitiveSetupPointSizeMaxWord = 7;
  localparam int unsigned PrimitiveSetupPointSizeMaxLsb = 0;
  localparam int unsigned PrimitiveSetupPointSizeMaxWidth = 32;
  localparam int unsigned PrimitiveSetupPointFadeThresholdWord = 8;
  localparam int unsigned PrimitiveSetupPointFadeThresholdLsb = 0;
  localparam int unsigned PrimitiveSetupPointFadeThresholdWidth = 32;
  localparam int unsigned PrimitiveSetupPointAttenuationWord = 9;
  localparam int unsigned PrimitiveSetupPointAttenuationLsb = 0;
  localparam int unsigned PrimitiveSetupPointAttenuationWidth = 32;
  localparam int unsigned PrimitiveSetupPointAttenuationElements = 3;

  // polygon_stipple
  localparam int unsigned PolygonStippleAddress = 25;
  localparam int unsigned PolygonStippleWords = 32;
  localparam logic [1023:0] PolygonStippleReset = {
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff, 32'hffffffff,
    32'hffffffff, 32'hffffffff
  };
  localparam int unsigned PolygonStippleRowWord = 0;
  localparam int unsigned PolygonStippleRowLsb = 0;
  localparam int unsigned PolygonStippleRowWidth = 32;
  localparam int unsigned PolygonStippleRowElements = 32;

  // scissor
  localparam int unsigned ScissorAddress = 26;
  localparam int unsigned ScissorWords = 2;
  localparam logic [63:0] ScissorReset = {
    32'h00000000, 32'h00000000
  };
  localparam int unsigned ScissorXWord = 0;
  localparam int unsigned ScissorXLsb = 0;
  localparam int unsigned ScissorXWidth = 16;
  localparam int unsigned ScissorYWord = 0;
  localparam int unsigned ScissorYLsb = 16;
  localparam int unsigned ScissorYWidth = 16;
  localparam int unsigned ScissorWidthWord = 1;
  localparam int unsigned ScissorWidthLsb = 0;
  localparam int unsigned ScissorWidthWidth = 16;
  localparam int unsigned ScissorHeightWord = 1;
  localparam int unsigned ScissorHeightLsb = 16;
  localparam int unsigned ScissorHeightWidth = 16;

  // texture_image
  localparam int unsigned TextureImageAddress = 27;
  localparam int unsigned TextureImageCount = 8;
  localparam int unsigned TextureImageWords = 3;
  localparam logic [95:0] TextureImageReset = {
    32'h00000000, 32'h00002001, 32'h00000200
  };
  localparam int unsigned TextureImageKindWord = 0;
  localparam int unsigned TextureImageKindLsb = 0;
  localparam int unsigned TextureImageKindWidth = 3;
  localparam int unsigned TextureImageFormatWord = 0;
  localparam int unsigned TextureImageFormatLsb = 3;
  localparam int unsigned TextureImageFormatWidth = 5;
  localparam int unsigned TextureImageBorderWord = 0;
  localparam int unsigned TextureImageBorderLsb = 8;
  localparam int unsigned TextureImageBorderWidth = 1;
  localparam int unsigned TextureImageLevelsWord = 0;
  localparam int unsigned TextureImageLevelsLsb = 9;
  localparam int unsigned TextureImageLevelsWidth = 4;
  localparam int unsigned TextureImageWidthWord = 0;
  localparam int unsigned TextureImageWidthLsb = 13;
  localparam int unsigned TextureImageWidthWidth = 13;
  localparam int unsigned TextureImageSrgbWord = 0;
  localparam int unsigned TextureImageSrgbLsb = 26;
  localparam int unsigned TextureImageSrgbWidth = 1;
  localparam int unsigned TextureImageHeightWord = 1;
  localparam int unsigned TextureImageHeightLsb = 0;
  localparam int unsigned TextureImageHeightWidth = 13;
  localparam int unsigned TextureImageDepthWord = 1;
  localparam int unsigned TextureImageDepthLsb = 13;
  localparam int unsigned TextureImageDepthWidth = 10;
  localparam int unsigned TextureImageAddressWord = 2;
  localparam int unsigned TextureImageAddressLsb = 0;
  localparam int unsigned TextureImageAddressWidth = 32;

  // sampler
  localparam int unsigned SamplerAddress = 35;
  localparam int unsigned SamplerCount = 8;
  localparam int unsigned SamplerWords = 5;
  localparam logic [159:0] SamplerReset = {
    32'h00000000, 32'h00000000, 32'h00001000, 32'hf0000000, 32'h18381200
  };
  localparam int unsigned SamplerWrap0Word = 0;
  localparam int unsigned SamplerWrap0Lsb = 0;
  localparam int unsigned SamplerWrap0Width = 3;
  localparam int unsigned SamplerWrap1Word = 0;
  localparam int unsigned SamplerWrap1Lsb = 3;
  localparam int unsigned SamplerWrap1Width = 3;
  localparam int unsigned SamplerWrap2Word = 0;
  localparam int unsigned SamplerWrap2Lsb = 6;
  localparam int unsigned SamplerWrap2Width = 3;
  localparam int unsigned SamplerMagnifyLinearWord = 0;
  localparam int unsigned SamplerMagnifyLinearLsb = 9;
  localparam int unsigned SamplerMagnifyLinearWidth = 1;
  localparam int unsigned SamplerMinifyLinearWord = 0;
  localparam int unsigned SamplerMinifyLinearLsb = 10;
  localparam int unsigned SamplerMinifyLinearWidth = 1;
  localparam int unsigned SamplerMipFilterWord = 0;
  localparam int unsigned SamplerMipFilterLsb = 11;
  localparam int unsigned SamplerMipFilterWidth = 2;
  localparam int unsigned SamplerBaseLevelWord = 0;
  localparam int unsigned SamplerBaseLevelLsb = 13;
  localparam int unsigned SamplerBaseLevelWidth = 4;
  localparam int unsigned SamplerMaxLevelWord = 0;
  localparam int unsigned SamplerMaxLevelLsb = 17;
  localparam int unsigned SamplerMaxLevelWidth = 4;
  localparam int unsigned SamplerMaxAnisotropyWord = 0;
  localparam int unsigned SamplerMaxAnisotropyLsb = 21;
  localparam int unsigned SamplerMaxAnisotropyWidth = 5;
  localparam int unsigned SamplerCompareEnableWord = 0;
  localparam int unsigned SamplerCompareEnableLsb = 26;
  localparam int unsigned SamplerCompareEnableWidth = 1;
  localparam int unsigned SamplerCompareWord = 0;
  localparam int unsigned SamplerCompareLsb = 27;
  localparam int unsigned SamplerCompareWidth = 3;
  localparam int unsigned SamplerDepthModeWord = 0;
  localparam int unsigned SamplerDepthModeLsb = 30;
  localparam int unsigned SamplerDepthModeWidth = 2;
  localparam int unsigned SamplerBiasWord = 1;
  localparam int unsigned SamplerBiasLsb = 0;
  localparam int unsigned SamplerBiasWidth = 16;
  localparam int unsigned SamplerMinLodWord = 1;
  localparam int unsigned SamplerMinLodLsb = 16;
  localparam int unsigned SamplerMinLodWidth = 16;
  localparam int unsigned SamplerMaxLodWord = 2;
  localparam int unsigned SamplerMaxLodLsb = 0;
  localparam int unsigned SamplerMaxLodWidth = 16;
  localparam int unsigned SamplerBorderColorWord = 3;
  localparam int unsigned SamplerBorderColorLsb = 0;
  localparam int unsigned SamplerBorderColorWidth = 32;
  localparam int unsigned SamplerBorderDepthWord = 4;
  localparam int unsigned SamplerBorderDepthLsb = 0;
  localparam int unsigned SamplerBorderDepthWidth = 24;

  // combiner
  localparam int unsigned CombinerAddress = 43;
  localparam int unsigned CombinerCount = 8;
  localparam int unsigned CombinerWords = 3;
  localparam logic [95:0] CombinerReset = {
    32'h00000000, 32'h0a28a280, 32'h14514500
  };
  localparam int unsigned CombinerEnableWord = 0;
  localparam int unsigned CombinerEnableLsb = 0;
  localparam int unsigned CombinerEnableWidth = 1;
  localparam int unsigned CombinerOp0Word = 0;
  localparam int unsigned CombinerOp0Lsb = 1;
  localparam int unsigned CombinerOp0Width = 4;
  localparam int unsigned CombinerScaleShift0Word = 0;
  localparam int unsigned CombinerScaleShift0Lsb = 5;
  localparam int unsigned CombinerScaleShift0Width = 2;
  localparam int unsigned CombinerSource0Word = 0;
  localparam int unsigned CombinerSource0Lsb = 7;
  localparam int unsigned CombinerSource0Width = 4;
  localparam int unsigned CombinerOperand0Word = 0;
  localparam int unsigned CombinerOperand0Lsb = 11;
  localparam int unsigned CombinerOperand0Width = 2;
  localparam int unsigned CombinerSource1Word = 0;
  localparam int unsigned CombinerSource1Lsb = 13;
  localparam int unsigned CombinerSource1Width = 4;
  localparam int unsigned CombinerOperand1Word = 0;
  localparam int unsigned CombinerOperand1Lsb = 17;
  localparam int unsigned CombinerOperand1Width = 2;
  localparam int unsigned CombinerSource2Word = 0;
  localparam int unsigned CombinerSource2Lsb = 19;
  localparam int unsigned CombinerSource2Width = 4;
  localparam int unsigned CombinerOperand2Word = 0;
  localparam int unsigned CombinerOperand2Lsb = 23;
  localparam int unsigned CombinerOperand2Width = 2;
  localparam int unsigned CombinerSource3Word = 0;
  localparam int unsigned CombinerSource3Lsb = 25;
  localparam int unsigned CombinerSource3Width = 4;
  localparam int unsigned CombinerOperand3Word = 0;
  localparam int unsigned CombinerOperand3Lsb = 29;
  localparam int unsigned CombinerOperand3Width = 2;
  localparam int unsigned CombinerOp1Word = 1;
  localparam int unsigned CombinerOp1Lsb = 0;
  localparam int unsigned CombinerOp1Width = 4;
  localparam int unsigned CombinerScaleShift1Word = 1;
  localparam int unsigned CombinerScaleShift1Lsb = 4;
  localparam int unsigned CombinerScaleShift1Width = 2;
  localparam int unsigned CombinerSource4Word = 1;
  localparam int unsigned CombinerSource4Lsb = 6;
  localparam int unsigned CombinerSource4Width = 4;
  localparam int unsigned CombinerOperand4Word = 1;
  localparam int unsigned CombinerOperand4Lsb = 10;
  localparam int unsigned CombinerOperand4Width = 2;
  localparam int unsigned CombinerSource5Word = 1;
  localparam int unsigned CombinerSource5Lsb = 12;
  localparam int unsigned CombinerSource5Width = 4;
  localparam int unsigned CombinerOperand5Word = 1;
  localparam int unsigned CombinerOperand5Lsb = 16;
  localparam int unsigned CombinerOperand5Width = 2;
  localparam int unsigned CombinerSource6Word = 1;
  localparam int unsigned CombinerSource6Lsb = 18;
  localparam int unsigned CombinerSource6Width = 4;
  localparam int unsigned CombinerOperand6Word = 1;
  localparam int unsigned CombinerOperand6Lsb = 22;
  localparam int unsigned CombinerOperand6Width = 2;
  localparam int unsigned CombinerSource7Word = 1;
  localparam int unsigned CombinerSource7Lsb = 24;
  localparam int unsigned CombinerSource7Width = 4;
  localparam int unsigned CombinerOperand7Word = 1;
  localparam int unsigned CombinerOperand7Lsb = 28;
  localparam int unsigned CombinerOperand7Width = 2;
  localparam int unsigned CombinerConstantWord = 2;
  localparam int unsigned CombinerConstantLsb = 0;
  localparam int unsigned CombinerConstantWidth = 32;

  // fog
  localparam int unsigned FogAddress = 51;
  localparam int unsigned FogWords = 4;
  localparam logic [127:0] FogReset = {
    32'h3f800000, 32'h00000000, 32'h3f800000, 32'h00000000
  };
  localparam int unsigned FogModeWord = 0;
  localparam int unsigned FogModeLsb = 0;
  localparam int unsigned FogModeWidth = 2;
  localparam int unsigned FogSourceWord = 0;
  localparam int unsigned FogSourceLsb = 2;
  localparam int unsigned FogSourceWidth = 2;
  localparam int unsigned FogColorWord = 0;
  localparam int unsigned FogColorLsb = 4;
  localparam int unsigned FogColorWidth = 24;
  localparam int unsigned FogDensityWord = 1;
  localparam int unsigned FogDensityLsb = 0;
  localparam int unsigned FogDensityWidth = 32;
  localparam int unsigned FogStartWord = 2;
  localparam int unsigned FogStartLsb = 0;
  localparam int unsigned FogStartWidth = 32;
  localparam int unsigned FogEndWord = 3;
  localparam int unsigned FogEndLsb = 0;
  localparam int unsigned FogEndWidth = 32;

  // fragment_control
  localparam int unsigned FragmentControlAddress = 52;
  localparam int unsigned FragmentControlWords = 1;
  localparam logic [31:0] FragmentControlReset = {
    32'h0000201c
  };
  localparam int unsigned FragmentControlColorSumWord = 0;
  localparam int unsigned FragmentControlColorSumLsb = 0;
  localparam int unsigned FragmentControlColorSumWidth = 1;
  localparam int unsigned FragmentControlAlphaTestWord = 0;
  localparam int unsigned FragmentControlAlphaTestLsb = 1;
  localparam int unsigned FragmentControlAlphaTestWidth = 1;
  localparam int unsigned FragmentControlAlphaCompareWord = 0;
  localparam int unsigned FragmentControlAlphaCompareLsb = 2;
  localparam int unsigned FragmentControlAlphaCompareWidth = 3;
  localparam int unsigned FragmentControlAlphaReferenceWord = 0;
  localparam int unsigned FragmentControlAlphaReferenceLsb = 5;
  localparam int unsigned FragmentControlAlphaReferenceWidth = 8;
  localparam int unsigned FragmentControlDitherWord = 0;
  localparam int unsigned FragmentControlDitherLsb = 13;
  localparam int unsigned FragmentControlDitherWidth = 1;
  localparam int unsigned FragmentControlCountSamplesWord = 0;
  localparam int unsigned FragmentControlCountSamplesLsb = 14;
  localparam int unsigned FragmentControlCountSamplesWidth = 1;

  // stencil
  localparam int unsigned StencilAddress = 53;
  localparam int unsigned StencilWords = 3;
  localparam logic [95:0] StencilReset = {
    32'h0000ffff, 32'h000007ff, 32'h1fe0000e
  };
  localparam int unsigned StencilEnableWord = 0;
  localparam int unsigned StencilEnableLsb = 0;
  localparam int unsigned StencilEnableWidth = 1;
  localparam int unsigned StencilCompare0Word = 0;
  localparam int unsigned StencilCompare0Lsb = 1;
  localparam int unsigned StencilCompare0Width = 3;
  localparam int unsigned StencilFail0Word = 0;
  localparam int unsigned StencilFail0Lsb = 4;
  localparam int unsigned StencilFail0Width = 3;
  localparam int unsigned StencilDepthFail0Word = 0;
  localparam int unsigned StencilDepthFail0Lsb = 7;
  localparam int unsigned StencilDepthFail0Width = 3;
  localparam int unsigned StencilDepthPass0Word = 0;
  localparam int unsigned StencilDepthPass0Lsb = 10;
  localparam int unsigned StencilDepthPass0Width = 3;
  localparam int unsigned StencilReference0Word = 0;
  localparam int unsigned StencilReference0Lsb = 13;
  localparam int unsigned StencilReference0Width = 8;
  localparam int unsigned StencilCompareMask0Word = 0;
  localparam int unsigned StencilCompareMask0Lsb = 21;
  localparam int unsigned StencilCompareMask0Width = 8;
  localparam int unsigned StencilWriteMask0Word = 1;
  localparam int unsigned StencilWriteMask0Lsb = 0;
  localparam int unsigned StencilWriteMask0Width = 8;
  localparam int unsigned StencilCompare1Word = 1;
  localparam int unsigned StencilCompare1Lsb = 8;
  localparam int unsigned StencilCompare1Width = 3;
  localparam int unsigned StencilFail1Word = 1;
  localparam int unsigned StencilFail1Lsb = 11;
  localparam int unsigned StencilFail1Width = 3;
  localparam int unsigned StencilDepthFail1Word = 1;
  localparam int unsigned StencilDepthFail1Lsb = 14;
  localparam int unsigned StencilDepthFail1Width = 3;
  localparam int unsigned StencilDepthPass1Word = 1;
  localparam int unsigned StencilDepthPass1Lsb = 17;
  localparam int unsigned StencilDepthPass1Width = 3;
  localparam int unsigned StencilReference1Word = 1;
  localparam int unsigned StencilReference1Lsb = 20;
  localparam int unsigned StencilReference1Width = 8;
  localparam int unsigned StencilCompareMask1Word = 2;
  localparam int unsigned StencilCompareMask1Lsb = 0;
  localparam int unsigned StencilCompareMask1Width = 8;
  localparam int unsigned StencilWriteMask1Word = 2;
  localparam int unsigned StencilWriteMask1Lsb = 8;
  localparam int unsigned StencilWriteMask1Width = 8;

  // depth_control
  localparam int unsigned DepthControlAddress = 54;
  localparam int unsigned DepthControlWords = 2;
  localparam logic [63:0] DepthControlReset = {
    32'h00ffffff, 32'h00000004
  };
  localparam int unsigned DepthControlTestEnableWord = 0;
  localparam int unsigned DepthControlTestEnableLsb = 0;
  localparam int unsigned DepthControlTestEnableWidth = 1;
  localparam int unsigned DepthControlWriteEnableWord = 0;
  localparam int unsigned DepthControlWriteEnableLsb = 1;
  localparam int unsigned DepthControlWriteEnableWidth = 1;
  localparam int unsigned DepthControlCompareWord = 0;
  localparam int unsigned DepthControlCompareLsb = 2;
  localparam int unsigned DepthControlCompareWidth = 3;
  localparam int unsigned DepthControlBoundsEnableWord = 0;
  localparam int unsigned DepthControlBoundsEnableLsb = 5;
  localparam int unsigned DepthControlBoundsEnableWidth = 1;
  localparam int unsigned DepthControlBoundsMinWord = 0;
  localparam int unsigned DepthControlBoundsMinLsb = 6;
  localparam int unsigned DepthControlBoundsMinWidth = 24;
  localparam int unsigned DepthControlBoundsMaxWord = 1;
  localparam int unsigned DepthControlBoundsMaxLsb = 0;
  localparam int unsigned DepthControlBoundsMaxWidth = 24;

  // blend
  localparam int unsigned BlendAddress = 55;
  localparam int unsigned BlendWords = 2;
  localparam logic [63:0] BlendReset = {
    32'h00000000, 32'hf010100c
  };
  localparam int unsigned BlendEnableWord = 0;
  localparam int unsigned BlendEnableLsb = 0;
  localparam int unsigned BlendEnableWidth = 1;
  localparam int unsigned BlendLogicOpEnableWord = 0;
  localparam int unsigned BlendLogicOpEnableLsb = 1;
  localparam int unsigned BlendLogicOpEnableWidth = 1;
  localparam int unsigned BlendLogicOpWord = 0;
  localparam int unsigned BlendLogicOpLsb = 2;
  localparam int unsigned BlendLogicOpWidth = 4;
  localparam int unsigned BlendRgbEquationWord = 0;
  localparam int unsigned BlendRgbEquationLsb = 6;
  localparam int unsigned BlendRgbEquationWidth = 3;
  localparam int unsigned BlendAlphaEquationWord = 0;
  localparam int unsigned BlendAlphaEquationLsb = 9;
  localparam int unsigned BlendAlphaEquationWidth = 3;
  localparam int unsigned BlendRgbSourceWord = 0;
  localparam int unsigned BlendRgbSourceLsb = 12;
  localparam int unsigned BlendRgbSourceWidth = 4;
  localparam int unsigned BlendRgbDestinationWord = 0;
  localparam int unsigned BlendRgbDestinationLsb = 16;
  localparam int unsigned BlendRgbDestinationWidth = 4;
  localparam int unsigned BlendAlphaSourceWord = 0;
  localparam int unsigned BlendAlphaSourceLsb = 20;
  localparam int unsigned BlendAlphaSourceWidth = 4;
  localparam int unsigned BlendAlphaDestinationWord = 0;
  localparam int unsigned BlendAlphaDestinationLsb = 24;
  localparam int unsigned BlendAlphaDestinationWidth = 4;
  localparam int unsigned BlendWriteMaskWord = 0;
  localparam int unsigned BlendWriteMaskLsb = 28;
  localparam int unsigned BlendWriteMaskWidth = 4;
  localparam int unsigned BlendConstantWord = 1;
  localparam int unsigned BlendConstantLsb = 0;
  localparam int unsigned BlendConstantWidth = 32;

  // multisample
  localparam int unsigned MultisampleAddress = 56;
  localparam int unsigned MultisampleWords = 1;
  localparam logic [31:0] MultisampleReset = {
    32'h00000078
  };
  localparam int unsigned MultisampleEnableWord = 0;
  localparam int unsigned MultisampleEnableLsb = 0;
  localparam int unsigned MultisampleEnableWidth = 1;
  localparam int unsigned MultisampleAlphaToCoverageWord = 0;
  localparam int unsigned MultisampleAlphaToCoverageLsb = 1;
  localparam int unsigned MultisampleAlphaToCoverageWidth = 1;
  localparam int unsigned MultisampleAlphaToOneWord = 0;
  localparam int unsigned MultisampleAlphaToOneLsb = 2;
  localparam int unsigned MultisampleAlphaToOneWidth = 1;
  localparam int unsigned MultisampleSampleMaskWord = 0;
  localparam int unsigned MultisampleSampleMaskLsb = 3;
  localparam int unsigned MultisampleSampleMaskWidth = 4;

  // targets
  localparam int unsigned TargetsAddress = 57;
  localparam int unsigned TargetsWords = 20;
  localparam logic [639:0] TargetsReset = {
    32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000,
    32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000,
    32'h00000001, 32'h00000000, 32'h00000000, 32'h00000000, 32'h00000001, 32'h00000000,
    32'h00000000, 32'h00000000
  };
  localparam int unsigned TargetsAddress0Word = 0;
  localparam int unsigned TargetsAddress0Lsb = 0;
  localparam int unsigned TargetsAddress0Width = 32;
  localparam int unsigned TargetsFormat0Word = 1;
  localparam int unsigned TargetsFormat0Lsb = 0;
  localparam int unsigned TargetsFormat0Width = 5;
  localparam int unsigned TargetsWidth0Word = 1;
  localparam int unsigned TargetsWidth0Lsb = 5;
  localparam int unsigned TargetsWidth0Width = 13;
  localparam int unsigned TargetsHeight0Word = 1;
  localparam int unsigned TargetsHeight0Lsb = 18;
  localparam int unsigned TargetsHeight0Width = 13;
  localparam int unsigned TargetsStride0Word = 2;
  localparam int unsigned TargetsStride0Lsb = 0;
  localparam int unsigned TargetsStride0Width = 32;
  localparam int unsigned TargetsSamples0Word = 3;
  localparam int unsigned TargetsSamples0Lsb = 0;
  localparam int unsigned TargetsSamples0Width = 3;
  localparam int unsigned TargetsAddress1Word = 4;
  localparam int unsigned TargetsAddress1Lsb = 0;
  localparam int unsigned TargetsAddress1Width = 32;
  localparam int unsigned TargetsFormat1Word = 5;
  localparam int unsigned TargetsFormat1Lsb = 0;
  localparam int unsigned TargetsFormat1Width = 5;
  localparam int unsigned TargetsWidth1Word = 5;
  localparam int unsigned TargetsWidth1Lsb = 5;
  localparam int unsigned TargetsWidth1Width = 13;
  localparam int unsigned TargetsHeight1Word = 5;
  localparam int unsigned TargetsHeight1Lsb = 18;
  localparam int unsigned TargetsHeight1Width = 13;
  localparam int unsigned TargetsStride1Word = 6;
  localparam int unsigned TargetsStride1Lsb = 0;
  localparam int unsigned TargetsStride1Width = 32;
  localparam int unsigned TargetsSamples1Word = 7;
  localparam int unsigned TargetsSamples1Lsb = 0;
  localparam int unsigned TargetsSamples1Width = 3;
  localparam int unsigned TargetsAddress2Word = 8;
  localparam int unsigned TargetsAddress2Lsb = 0;
  localparam int unsigned TargetsAddress2Width = 32;
  localparam int unsigned TargetsFormat2Word = 9;
  localparam int unsigned TargetsFormat2Lsb = 0;
  localparam int unsigned TargetsFormat2Width = 5;
  localparam int unsigned TargetsWidth2Word = 9;
  localparam int unsigned TargetsWidth2Lsb = 5;
  localparam int unsigned TargetsWidth2Width = 13;
  localparam int unsigned TargetsHeight2Word = 9;
  localparam int unsigned TargetsHeight2Lsb = 18;
  localparam int unsigned TargetsHeight2Width = 13;
  localparam int unsigned TargetsStride2Word = 10;
  localparam int unsigned TargetsStride2Lsb = 0;
  localparam int unsigned TargetsStride2Width = 32;
  localparam int unsigned TargetsSamples2Word = 11;
  localparam int unsigned TargetsSamples2Lsb = 0;
  localparam int unsigned TargetsSamples2Width = 3;
  localparam int unsigned TargetsAddress3Word = 12;
  localparam int unsigned TargetsAddress3Lsb = 0;
  localparam int unsigned TargetsAddress3Width = 32;
  localparam int unsigned TargetsFormat3Word = 13;
  localparam int unsigned TargetsFormat3Lsb = 0;
  localparam int unsigned TargetsFormat3Width = 5;
  localparam int unsigned TargetsWidth3Word = 13;
  localparam int unsigned TargetsWidth3Lsb = 5;
  localparam int unsigned TargetsWidth3Width = 13;
  localparam int unsigned TargetsHeight3Word = 13;
  localparam int unsigned TargetsHeight3Lsb = 18;
  localparam int unsigned TargetsHeight3Width = 13;
  localparam int unsigned TargetsStride3Word = 14;
  localparam int unsigned TargetsStride3Lsb = 0;
  localparam int unsigned TargetsStride3Width = 32;
  localparam int unsigned TargetsSamples3Word = 15;
  localparam int unsigned TargetsSamples3Lsb = 0;
  localparam int unsigned TargetsSamples3Width = 3;
  localparam int unsigned TargetsAddress4Word = 16;
  localparam int unsigned TargetsAddress4Lsb = 0;
  localparam int unsigned TargetsAddress4Width = 32;
  localparam int unsigned TargetsFormat4Word = 17;
  localparam int unsigned TargetsFormat4Lsb = 0;
  localparam int unsigned TargetsFormat4Width = 5;
  localparam int unsigned TargetsWidth4Word = 17;
  localparam int unsigned TargetsWidth4Lsb = 5;
  localparam int unsigned TargetsWidth4Width = 13;
  localparam int unsigned TargetsHeight4Word = 17;
  localparam int unsigned TargetsHeight4Lsb = 18;
  localparam int unsigned TargetsHeight4Width = 13;
  localparam int unsigned TargetsStride4Word = 18;
  localparam int unsigned TargetsStride4Lsb = 0;
  localparam int unsigned TargetsStride4Width = 32;
  localparam int unsigned TargetsSamples4Word = 19;
  localparam int unsigned TargetsSamples4Lsb = 0;
  localparam int unsigned TargetsSamples4Width = 3;

endpackage
