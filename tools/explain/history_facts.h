// What writers of histories reckon from them, once for all.

#pragma once

#include "tools/explain/pixel_history.h"

#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

// An argument of a texture environment: what is read, and what it was.
struct ArgumentFact {
    std::string source; // "Texture0"
    std::string_view operand;
    Rgba value{}; // with the operand applied: all channels of an alpha are alike
};

// Of the environment's half; `previous`: what came in.
std::vector<ArgumentFact> arguments_of(const FragmentNote& fragment,
                                       const EnvironmentNote& environment,
                                       const CombineHalf& half);

// The stencil state of the fragment's face.
const StencilFace& stencil_face(const FragmentNote& fragment);

// "Less(100, 200)" with both sides of a comparison.
std::string comparison(Compare compare, std::uint64_t reference, std::uint64_t stored);

// "SourceAlpha * source + OneMinusSourceAlpha * destination"
std::string blend_formula(BlendEquation equation, BlendFactor source, BlendFactor destination);

// Which channels a mask lets through: "rgb", "none"
std::string channels(unsigned mask);

// A name for each of a vertex' attributes, in their order: "color.r", "tex_coord1.s".
std::vector<std::string> attribute_names(const InterpolantLayout& layout);

// The unit's texel look-ups; pointers into the note.
const TexelLookup*
lookup_of(const FragmentNote& fragment, unsigned unit, unsigned level, const probed::Texel& texel);

} // namespace ffgpu::tools
