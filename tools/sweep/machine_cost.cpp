#include "tools/sweep/machine_cost.h"

#include <array>
#include <fstream>
#include <sstream>
#include <string_view>

namespace ffgpu::tools {
namespace {

struct Count {
    std::string_view unit;
    std::uint64_t number;
};

// Of a pipe that takes a quad a cycle.
constexpr std::array<Count, 11> OfPipe{{{"apply_coverage", 1},
                                        {"depth_plane", 1},
                                        {"attribute_plane", 9}, // 1/w, a color, a texture's
                                        {"reciprocal", 4},
                                        {"color_sum", 1},
                                        {"fog", 1},
                                        {"alpha_test", 1},
                                        {"stencil_depth", 1},
                                        {"blend", 1},
                                        {"quad_interlock", 1},
                                        {"texture_environment", 1}}};
// Of a texture unit, for each bilinear quad a cycle: four fragments, four texels each.
constexpr std::array<Count, 2> OfFilter{{{"filter_tree", 4}, {"texel_decode", 16}}};
constexpr std::array<Count, 1> OfRasterizer{{{"tile_walker", 1}}};

template <class Counts>
std::uint64_t sum(const Counts& counts, const UnitCosts& units) {
    std::uint64_t luts = 0;
    for (const Count& count : counts) {
        const auto found = units.find(std::string(count.unit));
        if (found != units.end()) luts += count.number * found->second;
    }
    return luts;
}

// The data and 32 bits of tag and state a line.
template <class Shape>
std::uint64_t bits(const Shape& shape) {
    return std::uint64_t{shape.sets} * shape.ways * (8 * std::uint64_t{shape.line_bytes} + 32);
}

} // namespace

UnitCosts read_unit_costs(const std::filesystem::path& page) {
    UnitCosts costs;
    std::ifstream file(page);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string bar, unit;
        std::uint64_t luts = 0;
        if (words >> bar >> unit >> bar >> luts) costs[unit] = luts;
    }
    return costs;
}

std::uint64_t cache_bits(const timing::TimingConfig& config) {
    const std::uint64_t pipes = config.raster.quads_per_cycle;
    std::uint64_t sum = bits(config.texel_cache) * (config.texel_cache.per_pipe ? pipes : 1);
    if (config.texel_l2.enable) sum += bits(config.texel_l2);
    if (config.raster.architecture == timing::Architecture::Immediate)
        sum += bits(config.depth_cache) + bits(config.color_cache);
    else // color and depth of a bin, on chip
        sum += std::uint64_t{config.raster.bin_size} * config.raster.bin_size * 64;
    return sum;
}

std::uint64_t machine_cost(const timing::TimingConfig& config, const UnitCosts& units) {
    constexpr std::uint64_t BitsOfLut = 16;
    const std::uint64_t filters =
        std::uint64_t{config.texture.units} * config.texel_cache.bilinear_quads_per_cycle;
    const std::uint64_t pipe = sum(OfPipe, units) + filters * sum(OfFilter, units);
    return config.raster.quads_per_cycle * pipe + sum(OfRasterizer, units) +
           cache_bits(config) / BitsOfLut;
}

} // namespace ffgpu::tools
