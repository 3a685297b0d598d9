// WholeCommand: a command that touches pixels, with all that became of it, in the canonical order
// (model/packets/fragment_key.h). Nothing tells any more in which bins and tiles the host drew it.
// What reads work in order reads these; they are never changed, and are shared between readers.

#pragma once

#include "model/packets/work_stream.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu::work {

struct WholeCommand {
    WorkDraw draw;
    std::vector<WorkQuad> quads;
    // Texture units in which the quads read, in rising order; and where the accesses of each quad
    // and unit begin: quads x units places and the end.
    std::vector<std::uint8_t> units;
    std::vector<std::uint32_t> access_begin{0};
    std::vector<TexelAccess> accesses; // TexelAccess::lane is 0 to 3, within the quad.
    // With WorkDetail::Values, where each quad's values begin, and the end; else empty.
    std::vector<std::uint32_t> value_begin;
    std::vector<std::uint32_t> values; // quad_values.h

    // Of quad `quad` in units[unit].
    std::span<const TexelAccess> accesses_of(std::size_t quad, std::size_t unit) const {
        const std::size_t at = quad * units.size() + unit;
        return std::span(accesses).subspan(access_begin[at],
                                           access_begin[at + 1] - access_begin[at]);
    }

    bool has_values() const { return !value_begin.empty(); }
    std::span<const std::uint32_t> values_of(std::size_t quad) const {
        return std::span(values).subspan(value_begin[quad],
                                         value_begin[quad + 1] - value_begin[quad]);
    }
};

// In the order of the commands, from one thread.
class CommandSink {
public:
    virtual ~CommandSink() = default;
    virtual void command(std::shared_ptr<const WholeCommand> command) = 0;
    // What a target holds now, with values; its before_draw means nothing.
    virtual void content(const std::shared_ptr<const SurfaceContent>& /*content*/) {}
    virtual void host_transfer(const HostTransfer& transfer) = 0; // its before_draw means nothing
    virtual void end_frame(std::uint32_t frame) = 0;
};

} // namespace ffgpu::work
