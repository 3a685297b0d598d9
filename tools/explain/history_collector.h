// HistoryCollector: a stage probe that keeps what is told of watched pixels' fragments, in their
// histories.

#pragma once

#include "tools/explain/pixel_history.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace ffgpu::tools {

class HistoryCollector final : public StageProbe {
public:
    // Events are added to the histories, whose places are to be known.
    explicit HistoryCollector(std::span<PixelHistory> histories);

    // From now on draws with numbers from `draw` on belong to this step of the tape.
    void begin_draw(std::uint32_t draw, std::size_t step, const TapeStep& what);

    // What was told so far is complete.
    void end_batch();

    // A pixel of a history, as it is now; others than fragments change it as well.
    struct Watch {
        std::size_t history = 0, place = 0;
        PixelValue value{};
    };
    std::vector<Watch>& watches() { return watches_; }

    // Of that draw; in the order of the stages, pixel by pixel.
    std::vector<std::shared_ptr<FragmentNote>> fragments_of(std::uint32_t draw) const;

    void set_up(const probed::SetUp&) override;
    void coverage(const probed::Batch&, const probed::Coverage&) override;
    void depth(const probed::Batch&) override;
    void perspective(const probed::Batch&, const probed::Perspective&) override;
    void colors(const probed::Batch&, const probed::Colors&) override;
    void tex_coords(const probed::Batch&, const probed::TexCoords&) override;
    void sampling(const probed::Batch&, const probed::Sampling&) override;
    void environment(const probed::Batch&, const probed::Environment&) override;
    void color_sum(const probed::Batch&, const ColorPlanes& before) override;
    void fog(const probed::Batch&, const probed::Fog&) override;
    void antialias(const probed::Batch&, const ColorPlanes& before) override;
    void sample_mask(const probed::Batch&, const SampleMasks& before) override;
    void alpha_test(const probed::Batch&, const probed::Test&) override;
    void stencil_depth(const probed::Batch&, const probed::StencilDepth&) override;
    void color_write(const probed::Batch&, const probed::ColorWrite&) override;

private:
    using PrimitiveName = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
    // A lane of the batch at hand whose fragment is watched, and the watches that it reaches.
    struct Tracked {
        unsigned lane = 0;
        std::shared_ptr<FragmentNote> note;
        std::vector<std::size_t> watches;
    };
    struct DrawOrigin {
        std::size_t step = 0;
        const TapeStep* what = nullptr;
    };

    PixelHistory& history(const Watch& watch) { return histories_[watch.history]; }
    const PixelPlace& place(const Watch& watch) const {
        return histories_[watch.history].places[watch.place];
    }
    std::vector<std::size_t>
    watches_at(const Targets& targets, unsigned x, unsigned y, std::size_t step) const;
    std::shared_ptr<const DrawState> state_of(const probed::Batch& batch);
    std::shared_ptr<FragmentNote>
    note_of(const probed::Batch& batch, const probed::Coverage& told, unsigned lane);
    void note_image(const probed::Batch& batch, unsigned lane, FragmentNote& note) const;
    void note_cut(const probed::SetUp& told, const PrimitiveNote& primitive);
    void note_stippled_out(const probed::SetUp& told);
    void note_unmade(PixelEvent::Kind why, const probed::SetUp& told, std::size_t watch);
    void end_fragment(Tracked& tracked);
    CallName call_of(std::uint32_t draw, std::uint32_t primitive) const;

    // Of fragments that have ended the stages tell nothing.
    template <class Note>
    void for_live(const probed::Batch& batch, Note&& note) {
        for (Tracked& tracked : tracked_)
            if (batch.fragments->live.test(tracked.lane)) note(tracked.lane, *tracked.note);
    }
    template <class Note>
    void for_lanes(const FragmentMask& mask, Note&& note) {
        for (Tracked& tracked : tracked_)
            if (mask.test(tracked.lane)) note(tracked.lane, *tracked.note);
    }

    std::span<PixelHistory> histories_;
    std::vector<Watch> watches_;
    // By the address of a pixel's first sample: watches.
    std::unordered_multimap<std::uint64_t, std::size_t> by_color_, by_depth_;
    unsigned x0_ = ~0u, y0_ = ~0u, x1_ = 0, y1_ = 0; // the window pixels that are watched
    std::map<std::uint32_t, DrawOrigin> draws_;
    std::map<std::uint32_t, std::shared_ptr<const DrawState>> states_;
    std::map<PrimitiveName, std::shared_ptr<const PrimitiveNote>> primitives_;
    std::map<std::uint32_t, std::vector<std::shared_ptr<FragmentNote>>> fragments_;
    std::vector<Tracked> tracked_;
};

} // namespace ffgpu::tools
