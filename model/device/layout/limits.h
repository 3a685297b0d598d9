// The sizes of the machine that its users can see.

#pragma once

#include <cstdint>

namespace ffgpu {

constexpr unsigned TextureUnits = 8;
constexpr unsigned Lights = 8;
constexpr unsigned ClipPlanes = 6;
constexpr unsigned MaxTextureLevels = 13; // 4096 down to 1.
constexpr unsigned MaxTextureSize = 4096; // 1-D, 2-D, cube and rectangle images, in texels.
constexpr unsigned MaxTexture3dSize = 512;
constexpr unsigned MaxSurfaceSize = 4096;     // Colour and depth targets, viewport, in pixels.
constexpr unsigned MaxImageSize = 0x7fffffff; // Width and height of an image draw: signed numbers.
constexpr unsigned SubPixelBits = 8;          // Vertices snap to 1/256 pixel.
constexpr unsigned ColorTargets = 8;          // Colour surfaces that a draw writes at once.
constexpr unsigned MaxSamples = 4;            // Of a pixel in a multisampled surface.
constexpr unsigned MaxPictures = 16;          // That a copy averages.

// Window coordinates after clipping lie within this many pixels of the origin, so that an edge
// function's step fits 24 bits (see model/raster).
constexpr int GuardBand = 8192;

} // namespace ffgpu
