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

struct QuadOfBatch {
    std::uint32_t batch = 0, quad = 0;
};

struct WholeCommand {
    WorkDraw draw;
    std::vector<WorkQuad> quads;
    // Texture units in which the quads read, in rising order; with any, of each quad where among
    // the batches of the draw its accesses are, and of each batch what it read in each unit.
    std::vector<std::uint8_t> units;
    std::vector<QuadOfBatch> sources;
    std::vector<const TexelFootprints*> footprints;    // null: nothing
    std::vector<std::shared_ptr<const WorkBin>> bins;  // of the footprints
    std::vector<std::shared_ptr<TexelFootprints>> own; // those that are in no bin
    // With WorkDetail::Values, where each quad's values begin, and the end; else empty.
    std::vector<std::uint32_t> value_begin;
    std::vector<std::uint32_t> values; // quad_values.h

    // Of quad `quad` in units[unit]; null: nothing.
    const TexelFootprints* footprints_of(std::size_t quad, std::size_t unit) const {
        if (quad >= sources.size()) return nullptr;
        const std::size_t at = sources[quad].batch * units.size() + unit;
        return at < footprints.size() ? footprints[at] : nullptr;
    }
    QuadReads accesses_of(std::size_t quad, std::size_t unit) const {
        const TexelFootprints* const read = footprints_of(quad, unit);
        return read ? read->of_quad(sources[quad].quad) : QuadReads();
    }
    // For who has no batches: what the last quad reads in units[unit] is added to these, with the
    // lane that first_lane() tells for its lane 0.
    TexelFootprints& own_footprints(std::size_t unit);
    unsigned first_lane() const { return 4 * sources.back().quad; }
    // One access of it, with the quad's lane.
    void add_access(std::size_t unit, TexelAccess access) {
        TexelFootprints& read = own_footprints(unit);
        access.lane = static_cast<std::uint16_t>(first_lane() + access.lane % 4u);
        read.add(access);
    }

    bool has_values() const { return !value_begin.empty(); }
    std::span<const std::uint32_t> values_of(std::size_t quad) const {
        return std::span(values).subspan(value_begin[quad],
                                         value_begin[quad + 1] - value_begin[quad]);
    }
};

// In the order of the commands, one after another.
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
