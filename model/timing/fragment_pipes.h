// The parallel fragment pipes: which of them a quad takes, one for each quad that the rasterizer
// makes a cycle, and how quads leave a unit that all pipes have.
//
// Where the window is shared out, a pixel always goes through the same pipe, and its fragments stay
// in order by themselves. Where primitives take turns they may not: then the quads leave in the
// order in which they came, whatever pipe they took.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/passage.h"
#include "model/timing/tokens.h"

#include <span>
#include <vector>

namespace ffgpu::timing {

// Of the squares (column, row) of a window that `pipes` pipes share, 1 to 16: rows begin with
// another pipe each, by the sequence of van der Corput (1935), so that where the pipes are a power
// of two each aligned block of as many squares, whatever its shape, has one of each pipe's: what
// is drawn at one time, in whatever order of tiles, is shared by all.
inline std::uint32_t pipe_of_square(std::uint32_t column, std::uint32_t row, std::uint32_t pipes) {
    constexpr std::uint64_t Reversed = 0xf7b3'd591'e6a2'c480; // four bits each, of 0 to 15
    const auto reversed = static_cast<std::uint32_t>(Reversed >> (row % 16 * 4) & 15);
    return (column + reversed * pipes / 16) % pipes;
}

inline std::uint32_t fragment_pipe(const TimingConfig& config, const QuadToken& token) {
    if (config.raster.quads_per_cycle == 1) return 0;
    const PreparedQuad& quad = token.quad();
    const std::uint32_t width = config.fragment.distribution_width;
    const std::uint32_t pipes = config.raster.quads_per_cycle;
    switch (config.fragment.distribution) {
    case Distribution::Tiles:
        return pipe_of_square(quad.x / width, quad.y / width, pipes);
    case Distribution::Scanlines:
        return quad.y / width % pipes;
    case Distribution::Triangles:
        break;
    }
    return (token.draw().number + quad.primitive) % pipes; // Draws of one primitive, too.
}

// The place of those that take turns, where none is further than once around.
inline std::size_t turn(std::size_t place, std::size_t places) {
    return place < places ? place : place - places;
}

// A unit's way out for the quads of all its pipes.
class PipeExit {
public:
    PipeExit(const TimingConfig& config, Channel<QuadToken>& out)
        : out_(out)
        , width_(config.raster.quads_per_cycle)
        , in_order_(config.fragment.distribution == Distribution::Triangles)
        , places_(config.fragment.pipe_queue)
        , finished_(width_)
        , passages_(width_) {}

    // A quad came in and takes `pipe`.
    void enter(std::uint32_t pipe) {
        if (in_order_) order_.push_back(pipe);
    }

    bool can_push(std::size_t pipe) const {
        return in_order_ ? finished_[pipe].size() < places_ : out_.can_push();
    }
    [[gnu::always_inline]] void push(std::size_t pipe, const QuadToken& quad) {
        if (!in_order_) return out_.push(quad);
        finished_[pipe].push_back(quad);
        ++passages_[pipe].entered;
    }

    // Once a cycle, when all pipes have worked: quads whose turn it is leave. Tells whether any
    // did.
    bool advance() { return !order_.empty() && send_in_order(); }

    bool is_empty() const { return order_.empty(); }
    // Where they leave in order: from each pipe to the way out. Else there are none.
    std::span<const Passage> passages() const {
        return std::span(passages_).first(in_order_ ? width_ : 0);
    }

private:
    bool send_in_order() {
        bool any = false;
        for (std::size_t i = 0; i < width_ && !order_.empty(); ++i) {
            Ring<QuadToken>& pipe = finished_[order_.front()];
            if (pipe.empty() || !out_.can_push()) break;
            out_.push(pipe.front());
            pipe.pop_front();
            passages_[order_.front()].leave();
            order_.pop_front();
            any = true;
        }
        return any;
    }

    Channel<QuadToken>& out_;
    std::size_t width_;
    bool in_order_;
    std::size_t places_; // of each pipe, for quads whose turn has not come
    Ring<std::uint32_t> order_;
    std::vector<Ring<QuadToken>> finished_;
    std::vector<Passage> passages_;
};

} // namespace ffgpu::timing
