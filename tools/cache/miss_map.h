// MissMap: where on the screen a texel cache misses, a picture a frame: quads with one miss are
// blue, with two green, with more red (as Z. Hakura and A. Gupta drew them, ISCA 1997).

#pragma once

#include "model/work/lookup_walk.h"
#include "model/work/tag_array.h"
#include "tools/cache/cache_geometry.h"
#include "tools/image/image.h"

#include <cstdint>
#include <vector>

namespace ffgpu::tools {

class MissMap final : private work::LookupSink {
public:
    // Of the machine's cache of this shape, whatever shape its configuration names.
    MissMap(const work::WorkConfig& config, const CacheGeometry& shape);

    work::CommandSink& sink() { return order_; }
    // Of the frame that ended last.
    Image picture(unsigned width, unsigned height) const;

private:
    static constexpr std::size_t Columns = 8192; // of quads

    void lookups(work::LookupClient client,
                 const work::LookupPlace& place,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t reads) override;
    void flush(work::LookupClient client) override;
    void overwritten(work::LookupClient client,
                     std::span<const work::OverwrittenLine> lines) override;
    void end_frame(std::uint32_t frame) override;

    work::TagArray tags_;
    std::vector<std::uint32_t> misses_, shown_; // by row and column of the quad
    work::LookupWalk walk_;
    work::MachineOrder order_;
};

} // namespace ffgpu::tools
