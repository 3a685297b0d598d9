// The configuration of the machine in time: one struct a unit (config/), every field with unit,
// range and meaning. Defaults describe a mid-size part of the early 2000s: one pipe of four
// fragments a cycle, a 16 KB texel cache, 16 bytes a cycle of memory bandwidth.

#pragma once

#include "model/timing/config/blocks.h"
#include "model/timing/config/bottlenecks.h"
#include "model/timing/config/cache.h"
#include "model/timing/config/clip.h"
#include "model/timing/config/clock.h"
#include "model/timing/config/command_processor.h"
#include "model/timing/config/depth.h"
#include "model/timing/config/fragment.h"
#include "model/timing/config/host.h"
#include "model/timing/config/interpolator.h"
#include "model/timing/config/raster.h"
#include "model/timing/config/scan_out.h"
#include "model/timing/config/series.h"
#include "model/timing/config/setup.h"
#include "model/timing/config/texel_l2.h"
#include "model/timing/config/texture.h"
#include "model/timing/config/tiles.h"
#include "model/timing/config/vertex.h"
#include "model/timing/memory/config.h"
#include "model/work/config.h"

#include <algorithm>
#include <string_view>
#include <type_traits>

namespace ffgpu::timing {

struct TimingConfig {
    HostConfig host;
    ClockConfig clock;
    CommandProcessorConfig command_processor;
    VertexConfig vertex;
    ClipConfig clip;
    SetupConfig setup;
    RasterConfig raster;
    InterpolatorConfig interpolator;
    TextureConfig texture;
    TilesConfig tiles;
    TexelCacheConfig texel_cache;
    TexelL2Config texel_l2;
    DepthCacheConfig depth_cache;
    ColorCacheConfig color_cache;
    FragmentConfig fragment;
    DepthConfig depth;
    HierarchicalDepthConfig hierarchical_depth;
    DepthBlockConfig depth_blocks;
    ColorBlockConfig color_blocks;
    ScanOutConfig scan_out;
    MemoryConfig memory;
    SeriesConfig series;
    BottlenecksConfig bottlenecks;

    // The part that work's order and places depend on.
    work::WorkConfig work() const {
        return {.raster = raster,
                .texel_cache = texel_cache,
                .depth_cache = depth_cache,
                .color_cache = color_cache,
                .tiles = tiles,
                .depth_test = depth.test};
    }

    // Of primitives from geometry to the clipper: on their way, as many a cycle as the wider end
    // takes, and in the queue.
    std::uint32_t primitive_places() const {
        if (clip.kept_places != 0) return clip.kept_places;
        return clip.queue + (vertex.latency - 1) * std::max(vertex.vertices_per_cycle, setup.units);
    }

    // What depends on values of depths and colours; empty: nothing.
    std::string_view needs_values() const {
        return depth.test == work::DepthTest::Late ? DepthConfig::Name : needs_contents();
    }
    // And on what a target holds, so that clears count, too.
    std::string_view needs_contents() const {
        if (hierarchical_depth.is_on()) return HierarchicalDepthConfig::Name;
        if (depth_blocks.is_on()) return DepthBlockConfig::Name;
        return color_blocks.is_on() ? ColorBlockConfig::Name : std::string_view{};
    }

    // Calls group(name, group) for each; then Group::visit names its fields.
    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& group) {
        const auto each = [&](auto& member) {
            group(std::remove_cvref_t<decltype(member)>::Name, member);
        };
        each(self.host);
        each(self.clock);
        each(self.command_processor);
        each(self.vertex);
        each(self.clip);
        each(self.setup);
        each(self.raster);
        each(self.interpolator);
        each(self.texture);
        each(self.tiles);
        each(self.texel_cache);
        each(self.texel_l2);
        each(self.depth_cache);
        each(self.color_cache);
        each(self.fragment);
        each(self.depth);
        each(self.hierarchical_depth);
        each(self.depth_blocks);
        each(self.color_blocks);
        each(self.scan_out);
        each(self.memory);
        each(self.series);
        each(self.bottlenecks);
    }
};

} // namespace ffgpu::timing
