// FrameFigures: what a measured frame was, besides its work: where a report's frame ends.

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ffgpu::work {

// Counters by name, in the order of their declaration.
using Figures = std::vector<std::pair<std::string, std::uint64_t>>;

struct FrameFigures {
    std::uint64_t number = 0;
    std::uint32_t width = 0, height = 0; // of the picture
    std::uint64_t api_calls = 0;
    Figures functional; // what the functional units counted

    bool operator==(const FrameFigures&) const = default;
};

} // namespace ffgpu::work
