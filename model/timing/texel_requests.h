// TexelRequests: the way in of a texture unit that takes texel after texel (TexelRate::Texels). Of
// each texture a quad has a request. Requests wait in their order; a sequencer makes a sample of
// each a cycle, and takes a cycle for the request itself; samples wait for the tags. What is full
// holds up what is behind it.

#pragma once

#include "model/base/ring.h"
#include "model/timing/config.h"
#include "model/timing/tokens.h"

#include <bit>
#include <cstdint>

namespace ffgpu::timing {

class TexelRequests {
public:
    explicit TexelRequests(const TextureConfig& config)
        : config_(config) {}

    // Of all fragments of a quad, all textures together.
    static std::uint32_t samples_of(const PreparedQuad& quad) {
        return std::uint32_t{quad.filter_steps} * live_lanes(quad);
    }

    // More requests than there are places come alone.
    bool can_take(const QuadToken& token) const {
        return requests_.empty() ||
               requests_.size() + token.quad().texture_count <= config_.request_queue;
    }
    void take(const QuadToken& token);

    // A cycle of the sequencer.
    void advance();
    // It has something to do.
    bool moves() const {
        return samples_left_ > 0 ? samples_ < config_.sample_queue : !requests_.empty();
    }

    bool has_sample() const { return samples_ > 0; }
    void pop_sample() { --samples_; }

private:
    static std::uint32_t live_lanes(const PreparedQuad& quad) {
        return static_cast<std::uint32_t>(std::popcount(quad.after_early_depth));
    }

    const TextureConfig& config_;
    Ring<std::uint32_t> requests_;   // samples of each
    std::uint32_t samples_left_ = 0; // of the request that the sequencer has
    std::uint32_t samples_ = 0;      // that wait for the tags
};

} // namespace ffgpu::timing
