#include "model/timing/target_blocks.h"

#include "model/base/input_error.h"

#include <string>

namespace ffgpu::timing {
namespace {

std::unique_ptr<BlockStates> make_states(std::string_view name,
                                         const BlockConfig& config,
                                         const CacheConfig& cache,
                                         const MemoryConfig& memory,
                                         HierarchicalDepth* coarse) {
    if (!config.is_on() && !coarse) return nullptr;
    const BlockStates::Shape shape{.line_bytes = cache.line_bytes,
                                   .transfer_bytes = cache.transfer_bytes,
                                   .burst_bytes = memory.burst_cycles * memory.bytes_per_cycle};
    return std::make_unique<BlockStates>(name, config, shape, coarse);
}

} // namespace

TargetBlocks::TargetBlocks(const TimingConfig& config)
    : coarse(config.hierarchical_depth.is_on()
                 ? std::make_unique<HierarchicalDepth>(config.hierarchical_depth,
                                                       config.depth_cache.line_bytes)
                 : nullptr)
    , depth(make_states(DepthBlockConfig::Name,
                        config.depth_blocks,
                        config.depth_cache,
                        config.memory,
                        coarse.get()))
    , color(make_states(ColorBlockConfig::Name,
                        config.color_blocks,
                        config.color_cache,
                        config.memory,
                        nullptr)) {}

std::vector<const StatisticsGroup*> TargetBlocks::statistics() const {
    std::vector<const StatisticsGroup*> groups;
    if (coarse) groups.push_back(&coarse->statistics);
    if (depth) groups.push_back(&depth->statistics());
    if (color) groups.push_back(&color->statistics());
    return groups;
}

void check_blocks(const TimingConfig& config) {
    const HierarchicalDepthConfig& coarse = config.hierarchical_depth;
    if (coarse.accepts && coarse.keeps != CoarseDepth::MinMax)
        throw InputError("hierarchical_depth.accepts: needs hierarchical_depth.keeps=min_max");
    if (config.raster.architecture != Architecture::TileBased) return;
    const auto refuse = [](bool is_on, std::string_view name) {
        if (is_on)
            throw InputError(std::string(name) +
                             ": its blocks are lines of a cache of the target, which machines with "
                             "raster.architecture=tile_based do not use");
    };
    refuse(coarse.is_on(), HierarchicalDepthConfig::Name);
    refuse(config.depth_blocks.is_on(), DepthBlockConfig::Name);
    refuse(config.color_blocks.is_on(), ColorBlockConfig::Name);
}

void check_values(const TimingConfig& config,
                  const work::WholeCommand& command,
                  bool contents_told) {
    const bool clears = command.draw.kind == WorkKind::Clear;
    const std::string_view name = clears ? config.needs_contents() : config.needs_values();
    if (name.empty() || (clears ? contents_told : command.quads.empty() || command.has_values()))
        return;
    throw InputError(std::string(name) +
                     ": needs the values of depths and colours, which this work was kept without: "
                     "expected --save-work together with --work-values");
}

} // namespace ffgpu::timing
