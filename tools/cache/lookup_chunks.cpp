#include "tools/cache/lookup_chunks.h"

#include <utility>

namespace ffgpu::tools {

void LookupChunk::play(work::LookupSink& sink, LookupPlaces& places) const {
    std::size_t lookup = 0, line = 0;
    for (const Step& step : steps_) {
        switch (step.kind) {
        case Kind::Lookups: {
            work::LookupPlace& place = places.of(step.client);
            if (step.since != work::Reuse::Quad) {
                ++place.number;
                place.begin(static_cast<work::Reuse>(static_cast<unsigned>(step.since) - 1));
            }
            sink.lookups(step.client,
                         place,
                         std::span(lookups_).subspan(lookup, step.end - lookup),
                         step.number);
            lookup = step.end;
            break;
        }
        case Kind::Flush:
            sink.flush(step.client);
            break;
        case Kind::Overwritten:
            sink.overwritten(step.client, std::span(overwritten_).subspan(line, step.end - line));
            line = step.end;
            break;
        case Kind::EndFrame:
            sink.end_frame(step.number);
        }
    }
}

void LookupChunker::add(const LookupChunk::Step& step) {
    chunk_->steps_.push_back(step);
    if (chunk_->weight() >= Weight) finish();
}

void LookupChunker::finish() {
    if (chunk_->weight() > 0) hand_over_(std::exchange(chunk_, std::make_shared<LookupChunk>()));
}

void LookupChunker::lookups(work::LookupClient client,
                            const work::LookupPlace& place,
                            std::span<const work::LineLookup> lines,
                            std::uint32_t reads) {
    auto& all = chunk_->lookups_;
    all.insert(all.end(), lines.begin(), lines.end());
    auto& last = client == work::LookupClient::Vertex ? last_vertex_ : last_quad_;
    const work::Reuse since = last ? place.since(*last) : work::Reuse::EarlierFrame;
    last = place.number;
    add({.number = reads,
         .end = static_cast<std::uint32_t>(all.size()),
         .kind = LookupChunk::Kind::Lookups,
         .client = client,
         .since = since});
}

void LookupChunker::flush(work::LookupClient client) {
    add({.kind = LookupChunk::Kind::Flush, .client = client});
}

void LookupChunker::overwritten(work::LookupClient client,
                                std::span<const work::OverwrittenLine> lines) {
    auto& all = chunk_->overwritten_;
    all.insert(all.end(), lines.begin(), lines.end());
    add({.end = static_cast<std::uint32_t>(all.size()),
         .kind = LookupChunk::Kind::Overwritten,
         .client = client});
}

void LookupChunker::end_frame(std::uint32_t frame) {
    add({.number = frame, .kind = LookupChunk::Kind::EndFrame});
}

} // namespace ffgpu::tools
