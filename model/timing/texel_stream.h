// TexelStream: the texture unit of a fragment pipe that takes texel after texel
// (TexelRate::Texels). Tags run ahead of the data by texture.texel_queue texels; a quad leaves when
// its last texel was read, and the time of the filters behind has passed. Quads without samples
// pass in their order.

#pragma once

#include "model/base/ring.h"
#include "model/timing/parked_quads.h"
#include "model/timing/texel_requests.h"
#include "model/timing/tokens.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ffgpu::timing {

class TexelStream {
public:
    TexelStream(const TextureConfig& config, LineCache& cache, std::uint32_t outstanding_lines)
        : config_(config)
        , cache_(cache)
        , outstanding_(outstanding_lines) {}

    // Quads between their first tag and their leaving.
    std::size_t quads() const { return quads_.size(); }
    bool is_comparing() const { return comparing_; }
    // The quad whose tags are compared.
    const QuadToken& current() const { return current_; }
    void begin(const QuadToken& quad);

    // A cycle's work; false, and the reason, where it is none: a quad without samples is no work,
    // nor is one whose next sample has not come. `look_up` is told a line's number and gives the
    // cache's result.
    template <class LookUp>
    bool compare(TexelRequests& requests, Activity& reason, const LookUp& look_up);
    bool read_texel(Cycle now, Activity& reason);

    bool can_leave(Cycle now) const { return read_quads_ > 0 && quads_.front().ready_at <= now; }
    // Some cycles have to pass, and then the oldest quad can leave.
    bool waits() const {
        return read_quads_ > 0 || (!quads_.empty() && quads_.front().texels == 0);
    }
    const QuadToken& front() const { return quads_.front().quad; }
    void pop();

    // Since the start: texels whose tags were compared, and quads whose texels were read.
    std::uint32_t tagged() const { return tagged_; }
    std::uint32_t read_quads() const {
        return gone_quads_ + static_cast<std::uint32_t>(read_quads_);
    }
    // Of the texel that was read last.
    std::uint64_t ticket_read() const { return ticket_read_; }
    // The next texel begins a sample that has not come.
    bool lacks_sample(const TexelRequests& requests) const {
        return texel_ < texels_ && begins_sample() && !requests.has_sample();
    }

private:
    struct Quad {
        QuadToken quad;
        std::uint32_t texels = 0; // that were not read
        Cycle ready_at = 0;
    };
    struct Texel {
        std::uint64_t ticket = 0;
        bool missed = false;
        bool last = false; // of its quad
    };

    void read_empty_quads(Cycle now);
    // The quad's texels are spread evenly over its samples.
    bool begins_sample() const {
        return std::uint64_t{texel_} * samples_ >= std::uint64_t{sample_} * texels_;
    }

    const TextureConfig& config_;
    LineCache& cache_;
    std::uint32_t outstanding_;
    bool comparing_ = false;
    QuadToken current_;
    std::uint32_t texels_ = 0, texel_ = 0;   // of the quad
    std::uint32_t samples_ = 0, sample_ = 0; // of the quad; that were begun
    std::size_t line_ = 0;                   // that is looked up next
    std::uint64_t ticket_ = 0;               // the latest of its lines'
    Ring<Texel> queue_;                      // between tags and data
    std::uint32_t misses_ = 0;               // in the queue
    Ring<Quad> quads_;
    std::size_t read_quads_ = 0; // whose texels are read, the oldest
    std::uint32_t tagged_ = 0, gone_quads_ = 0;
    std::uint64_t ticket_read_ = 0;
};

template <class LookUp>
bool TexelStream::compare(TexelRequests& requests, Activity& reason, const LookUp& look_up) {
    if (texel_ < texels_) {
        const bool begins = begins_sample();
        if (begins && !requests.has_sample()) return false;
        const bool full = queue_.size() >= config_.texel_queue || misses_ >= outstanding_;
        const auto lines = current_.part->work.lines_of(current_.quad());
        bool missed = false;
        // Lines come about as evenly as texels do.
        const std::size_t wanted = (std::size_t{texel_} + 1) * lines.size();
        for (; !full && line_ * texels_ < wanted && line_ < lines.size(); ++line_) {
            const LookupResult result = look_up(lines[line_]);
            if (!result.accepted) {
                blame(reason, Activity::StalledRequests);
                return false;
            }
            missed |= result.missed;
            ticket_ = std::max(ticket_, result.ticket);
        }
        if (full) {
            blame(reason, Activity::StalledMemory);
            return false;
        }
        if (begins) {
            requests.pop_sample();
            ++sample_;
        }
        misses_ += missed;
        quads_.back().quad.misses += missed;
        queue_.push_back({ticket_, missed, ++texel_ == texels_});
        ++tagged_;
    }
    comparing_ = texel_ < texels_;
    return texels_ > 0;
}

} // namespace ffgpu::timing
