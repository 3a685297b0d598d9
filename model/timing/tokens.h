// What travels between the units: small values that point into scenes. Each says by key() what of
// the work it is.

#pragma once

#include "model/timing/command_ledger.h"
#include "model/timing/unit.h"
#include "model/work/prepared_work.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace ffgpu::timing {

using work::PreparedDraw;
using work::PreparedQuad;

// Bytes of device memory that the host wrote.
struct HostWrite {
    std::uint64_t begin = 0, end = 0;
};

struct TimedScene;
struct QuadToken;

// Quads of a scene that were told together.
struct TimedPart {
    TimedPart(work::PreparedQuads&& quads, TimedScene& of, std::uint32_t first_quad)
        : work(std::move(quads))
        , scene(&of)
        , first(first_quad)
        , end(first_quad + static_cast<std::uint32_t>(work.quads.size())) {}

    work::PreparedQuads work;
    TimedScene* scene;
    std::uint32_t first, end; // of the scene's quads

    bool has(std::uint32_t quad) const { return quad - first < end - first; }
};

// A scene on its way through the machine. Its quads may come in parts, behind it.
struct TimedScene {
    TimedScene(work::PreparedScene&& prepared, CommandLedger& ledger)
        : work(std::move(prepared))
        , ledger_(ledger)
        , first_entry_(open_draws())
        , quads_(static_cast<std::uint32_t>(work.quads.size() + work.quads_to_come)) {
        index_bins();
        if (!work.quads.empty()) add(std::move(work));
    }
    TimedScene(const TimedScene&) = delete;
    TimedScene& operator=(const TimedScene&) = delete;

    void add(work::PreparedPart&& part) {
        work::set_ends(part.ends, work);
        add(static_cast<work::PreparedQuads&&>(part));
    }
    // So many quads of it were told; others come.
    std::uint32_t told_quads() const { return told_quads_; }
    bool waits_for_quads() const { return told_quads_ != quads_; }
    // That with this quad, which was told.
    const TimedPart& part_of(std::uint32_t quad) const {
        if (parts_.size() == 1) return parts_.front();
        const auto behind = std::upper_bound(
            parts_.begin(), parts_.end(), quad, [](std::uint32_t wanted, const TimedPart& part) {
                return wanted < part.first;
            });
        return *std::prev(behind);
    }

    work::PreparedScene work;           // Its quads and their lines are in the parts.
    std::uint64_t number = 0;           // in the machine's order
    std::vector<HostWrite> host_writes; // before its draws; the vertex fetch takes them

    // By the unit that reads a draw last.
    void end_draw(std::uint32_t draw, std::uint64_t now) {
        ++ended_draws_;
        ledger_.end_part(first_entry_ + draw, now);
    }
    // By the unit that ends a quad: the last of the pipe, or one in which no fragment was left.
    void retire_quad(const QuadToken& quad, std::uint64_t now);
    void end_dead_quad(const QuadToken& quad, std::uint64_t now);
    // Tile-based: the bin was walked to its end, and all its quads ended, in cycles before this
    // one.
    bool bin_is_drawn(std::uint32_t bin, std::uint64_t now) const {
        return bins_[bin].is_drawn() && bins_[bin].changed < now;
    }
    // By the rasterizer, in the last cycle of the walk.
    void end_walk(std::uint32_t bin, std::uint64_t now) {
        bins_[bin].walked = true;
        change_bin(bins_[bin], now);
    }
    // The unit that asks it.
    void set_bin_waiter(Unit& waiter) { bin_waiter_ = &waiter; }
    // Tile-based: by the unit that stores bins.
    void end_pass() { ++ended_passes_; }

    // No token points in here any more.
    bool is_done() const {
        return ended_draws_ == work.draws.size() && ended_quads_ == quads_ &&
               ended_passes_ == work.tiles.passes.size();
    }

private:
    void add(work::PreparedQuads&& quads) {
        told_quads_ = parts_.emplace_back(std::move(quads), *this, told_quads_).end;
    }
    // A draw is through set-up once and ends with each of its quads.
    std::size_t open_draws() {
        std::size_t first = 0;
        for (const PreparedDraw& draw : work.draws) {
            const std::size_t entry = ledger_.open(
                command_kind(draw.kind), draw.number, std::uint64_t{draw.quad_count} + 1);
            ledger_.set_shape(entry, draw.shape);
            if (&draw == work.draws.data()) first = entry;
        }
        return first;
    }

    void index_bins() {
        if (work.tiles.passes.empty()) return;
        bin_of_quad_.resize(work.quads.size());
        for (const work::TileBin& bin : work.tiles.bins) {
            for (std::uint32_t quad = bin.quads_begin; quad < bin.quads_end; ++quad)
                bin_of_quad_[quad] = static_cast<std::uint32_t>(bins_.size());
            bins_.push_back(
                {bin.quads_end - bin.quads_begin, bin.pieces_begin == bin.pieces_end, 0});
        }
    }
    void end_quad(std::uint32_t quad, std::uint64_t now) {
        ++ended_quads_;
        if (bins_.empty()) return;
        Bin& bin = bins_[bin_of_quad_[quad]];
        --bin.quads_left;
        change_bin(bin, now);
    }

    struct Bin {
        std::uint32_t quads_left = 0;
        bool walked = false; // to its end
        std::uint64_t changed = 0;

        bool is_drawn() const { return walked && quads_left == 0; }
    };
    void change_bin(Bin& bin, std::uint64_t now) {
        bin.changed = now;
        if (bin.is_drawn()) bin_waiter_->wake();
    }

    CommandLedger& ledger_;
    std::size_t first_entry_;
    std::uint32_t quads_; // told, or to come
    std::uint32_t told_quads_ = 0;
    std::deque<TimedPart> parts_;
    std::uint64_t ended_draws_ = 0, ended_quads_ = 0, ended_passes_ = 0;
    std::vector<Bin> bins_;
    std::vector<std::uint32_t> bin_of_quad_;
    Unit* bin_waiter_ = nullptr;
};

struct DrawToken {
    TimedScene* scene = nullptr;
    std::uint32_t draw = 0;

    const PreparedDraw& prepared() const { return scene->work.draws[draw]; }
    std::string key() const;
};

struct VertexToken {
    DrawToken draw;
    std::uint32_t position = 0; // in the draw's sequence of vertices
    bool shade = false;         // false: the post-transform reuse had it

    // An image has no vertices: it passes as one token.
    bool ends_draw() const {
        return position + 1 == std::max<std::size_t>(draw.prepared().geometry.vertices.size(), 1);
    }
    std::string key() const;
};

struct PrimitiveToken {
    static constexpr std::uint32_t None = ~0u; // It only ends its draw.

    DrawToken draw;
    std::uint32_t primitive = 0; // of its draw
    bool last = false;           // of its draw

    const work::PreparedPrimitive& prepared() const {
        const work::PreparedScene& scene = draw.scene->work;
        return scene.primitives[draw.prepared().first_primitive + primitive];
    }
    std::string key() const;
};

// A piece that was set up, or a primitive without one. Tile-based machines bin it.
struct SetupToken {
    DrawToken draw;
    std::uint32_t begin = 0, end = 0;
    bool last = false; // of its draw

    std::string key() const;
};

struct QuadToken {
    const TimedPart* part = nullptr;
    std::uint32_t index = 0;  // in the part
    std::uint32_t misses = 0; // texel lines that were not in the cache

    const PreparedQuad& quad() const { return part->work.quads[index]; }
    const PreparedDraw& draw() const { return scene().work.draws[quad().draw]; }
    TimedScene& scene() const { return *part->scene; }
    std::uint32_t number() const { return part->first + index; } // of the scene's quads
    // Of a draw with values.
    QuadValues values() const { return part->work.values_of(draw(), quad()); }
    std::string key() const;
};

inline void TimedScene::retire_quad(const QuadToken& quad, std::uint64_t now) {
    end_quad(quad.number(), now);
    ledger_.retire(first_entry_ + quad.quad().draw, now);
}
inline void TimedScene::end_dead_quad(const QuadToken& quad, std::uint64_t now) {
    end_quad(quad.number(), now);
    ledger_.end_part(first_entry_ + quad.quad().draw, now);
}

} // namespace ffgpu::timing
