// CacheStudy: the miss-rate curves of an application: for each client, layout, raster order and
// line size the curves of all caches, from one pass over its work.

#pragma once

#include "model/work/lookups.h"
#include "model/work/miss_curves.h"
#include "tools/cache/cache_geometry.h"
#include "tools/config/configuration.h"
#include "tools/frames/frame_range.h"
#include "tools/image/image.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct RasterChoice {
    work::Traversal traversal = work::Traversal::Tiled;
    std::uint32_t tile_width = 8;

    bool operator==(const RasterChoice&) const = default;
};

struct CacheStudyOptions {
    std::string input{};
    FrameRange frames{};
    Configuration configuration{}; // of all that is not varied
    std::vector<work::LookupClient> clients{work::LookupClient::Texel};
    std::vector<std::uint32_t> line_bytes{32, 64, 128};
    std::vector<work::Layout> layouts{}; // of textures and targets; empty: as configured
    std::vector<RasterChoice> orders{};  // empty: as configured
    std::uint32_t most_sets = 4096, most_ways = 32;
    bool merges = true;                         // a quad's reads of a line are one look-up
    std::optional<CacheGeometry> first_level{}; // Curves of texels are then of caches behind it.
    std::optional<CacheGeometry> miss_map{};    // of texels, in the first variant
    std::function<void(std::uint64_t frame, const Image& map)> on_miss_map{};
    std::function<void(const std::string& line)> warn = [](const std::string&) {};
};

// A machine of those that are studied.
struct CacheVariant {
    work::Layout layout = work::Layout::Blocked; // of textures; of depths, of colours
    RasterChoice order;
    work::Granularity granularity = work::Granularity::Quad;
    bool merges = true;
};

struct CurveResult {
    work::LookupClient client = work::LookupClient::Texel;
    CacheVariant variant;
    bool second_level = false;
    std::uint32_t line_bytes = 64;
    std::uint64_t reads = 0; // texels, samples or vertices
    work::CurveSums sums;
    std::vector<std::uint64_t> frame_lines; // different ones that each frame looked up
};

struct CacheStudyResult {
    std::vector<std::uint64_t> frames; // their numbers
    std::vector<CurveResult> curves;
};

// `result` holds the frames that were finished, and nothing of others, when this throws InputError.
void study_caches(const CacheStudyOptions& options, CacheStudyResult& result);

// The caches of a client whose curves are told: all that were followed, and fully associative ones
// up to where nothing but compulsory misses is left.
std::vector<CacheGeometry> told_geometries(const CacheStudyOptions& options,
                                           const CurveResult& curve);

} // namespace ffgpu::tools
