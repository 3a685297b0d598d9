#include "model/timing/texel_stream.h"

#include <algorithm>

namespace ffgpu::timing {

// A sample reads a texel at least; the border's take their cycles, and no line.
void TexelStream::begin(const QuadToken& quad) {
    const PreparedQuad& work = quad.quad();
    current_ = quad;
    comparing_ = true;
    samples_ = TexelRequests::samples_of(work);
    sample_ = 0;
    texels_ = std::max(std::uint32_t{work.texel_reads} + work.border_texels, samples_);
    texel_ = 0;
    line_ = 0;
    ticket_ = 0;
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
    ticket_read_ = texel.ticket;
    Quad& quad = quads_[read_quads_];
    --quad.texels;
    if (texel.last) quad.ready_at = now + config_.latency;
    read_empty_quads(now);
    return true;
}

void TexelStream::pop() {
    quads_.pop_front();
    --read_quads_;
    ++gone_quads_;
}

} // namespace ffgpu::timing
