// An oracle is a technique's formula, evaluated in double precision for one point of the window.
// Oracles restate the programs' scenes in numbers of their own; they share no code with the
// renderer or the library of techniques, only the images that both are given.

#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ffgpu::gallery {

using Color = glm::dvec3;
// A point of the window in pixels, the origin at the lower left; pixel centres at half integers.
using Oracle = std::function<Color(const glm::dvec2& window)>;

constexpr int WindowWidth = 320, WindowHeight = 240;

struct Claim {
    std::string_view row;     // T1 ...
    std::string_view formula; // as the page prints it
    Oracle (*oracle)();
    // The place of a pixel is known to this many pixels: the value has to lie between the formula's
    // values within it. What is left of the difference counts, in units of 1/255.
    double reach;
    double worst_allowed; // of the channels of all pixels
    double rms_allowed;
    std::string_view reason;   // why not 0
    std::string_view mutation; // what the broken program does
};

const std::vector<Claim>& claims();
// Of a row of the textbook, or of the filters' strip.
const Claim& claim_of(std::string_view row);

} // namespace ffgpu::gallery
