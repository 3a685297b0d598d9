#include "model/timing/texel_stream.h"

#include <bit>

namespace ffgpu::timing {

// One texel a sample: the samples of a quad are told apart by a cycle.
void TexelStream::begin(const QuadToken& quad) {
    const PreparedQuad& work = quad.quad();
    current_ = quad;
    comparing_ = true;
    texels_ = work.texel_reads;
    texel_ = 0;
    line_ = 0;
    ticket_ = 0;
    const auto lanes = static_cast<unsigned>(std::popcount(work.after_early_depth));
    pause_ = texels_ > 0 && texels_ <= work.filter_steps * lanes ? 1 : 0;
    quads_.push_back({quad, texels_, 0});
}

// Of those in front, quads without samples.
void TexelStream::read_empty_quads(Cycle now) {
    for (; read_quads_ < quads_.size() && quads_[read_quads_].texels == 0; ++read_quads_)
        if (quads_[read_quads_].ready_at == 0) quads_[read_quads_].ready_at = now;
}

// The oldest texel's data, where its line has come.
bool TexelStream::read_texel(Cycle now, Activity& reason) {
    read_empty_quads(now);
    if (queue_.empty()) return false;
    const Texel texel = queue_.front();
    if (!cache_.is_complete(texel.ticket)) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    queue_.pop_front();
    misses_ -= texel.missed;
    Quad& quad = quads_[read_quads_];
    --quad.texels;
    if (texel.last) quad.ready_at = now + config_.latency;
    read_empty_quads(now);
    return true;
}

void TexelStream::pop() {
    quads_.pop_front();
    --read_quads_;
}

} // namespace ffgpu::timing
