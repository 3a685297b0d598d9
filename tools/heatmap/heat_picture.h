// Pictures of heat maps: a colour for each number, over the frame if so wanted, and below them a
// strip that tells what the colours mean.

#pragma once

#include "tools/heatmap/heat_recorder.h"
#include "tools/image/image.h"

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace ffgpu::tools {

struct HeatMapOptions {
    std::set<HeatMap> maps;
    std::optional<double> full_scale; // 0: what one pixel in 200 exceeds; nothing: the map's
    unsigned tile = 1;                // A number is the mean over squares of so many pixels.
    bool blend = false;               // with the frame
    bool raw = false;                 // also as .npy
};

// "auto" or a number above 0. Throws InputError.
double parse_heat_scale(const std::string& text);

// Black, blue, cyan, green, yellow, red, white in equal steps for 0 to 1; beyond 1 white.
std::array<std::uint8_t, 3> heat_color(double value);

// The mean of each square, at all of its pixels.
HeatPlane averaged(const HeatPlane& plane, unsigned tile);

// Of a map of names: the one that most pixels of each square have, at all of its pixels; of two the
// first.
HeatPlane most_common(const HeatPlane& plane, unsigned tile);

// Colours that tell the names of a map apart, from 1 on; 0 is black.
std::array<std::uint8_t, 3> name_color(std::size_t number);

// `frame`: of the plane's size. The legend of a map of names lists those that occur.
Image heat_picture(HeatMap map,
                   const HeatPlane& plane,
                   const HeatMapOptions& options,
                   const Image& frame);

} // namespace ffgpu::tools
