#include "tools/cache/lookup_chunks.h"

#include <utility>

namespace ffgpu::tools {

void LookupChunk::play(work::LookupSink& sink) const {
    std::size_t lookup = 0, line = 0;
    for (const Step& step : steps_) {
        switch (step.kind) {
        case Kind::Lookups:
            sink.lookups(step.client,
                         step.place,
                         std::span(lookups_).subspan(lookup, step.end - lookup),
                         step.number);
            lookup = step.end;
            break;
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

void LookupChunker::hand_over_full() {
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
    chunk_->steps_.push_back({LookupChunk::Kind::Lookups, client, reads, all.size(), place});
    hand_over_full();
}

void LookupChunker::flush(work::LookupClient client) {
    chunk_->steps_.push_back({.kind = LookupChunk::Kind::Flush, .client = client});
    hand_over_full();
}

void LookupChunker::overwritten(work::LookupClient client,
                                std::span<const work::OverwrittenLine> lines) {
    auto& all = chunk_->overwritten_;
    all.insert(all.end(), lines.begin(), lines.end());
    chunk_->steps_.push_back(
        {.kind = LookupChunk::Kind::Overwritten, .client = client, .end = all.size()});
    hand_over_full();
}

void LookupChunker::end_frame(std::uint32_t frame) {
    chunk_->steps_.push_back({.kind = LookupChunk::Kind::EndFrame, .number = frame});
    hand_over_full();
}

} // namespace ffgpu::tools
