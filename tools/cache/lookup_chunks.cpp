#include "tools/cache/lookup_chunks.h"

#include <utility>

namespace ffgpu::tools {

LookupChunk::Step LookupChunk::step(Kind kind, work::LookupClient client, std::size_t end) const {
    return {.end = static_cast<std::uint32_t>(end), .kind = kind, .client = client};
}

// Relative to the place: a quad that begins all that is its own has 0 there.
std::uint32_t LookupChunk::add_scopes(const work::LookupPlace& place) {
    Scopes scopes = place.began;
    scopes[0] = place.number - place.began[0];
    if (scopes_.empty() || scopes_.back() != scopes) scopes_.push_back(scopes);
    return static_cast<std::uint32_t>(scopes_.size() - 1);
}

work::LookupPlace LookupChunk::place_of(const Step& step) const {
    work::LookupPlace place{step.place, scopes_[step.scopes], step.x, step.y};
    place.began[0] = step.place - place.began[0];
    return place;
}

void LookupChunk::play(work::LookupSink& sink) const {
    std::size_t lookup = 0, line = 0;
    for (const Step& step : steps_) {
        switch (step.kind) {
        case Kind::Lookups:
            sink.lookups(step.client,
                         place_of(step),
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
    LookupChunk::Step step = chunk_->step(LookupChunk::Kind::Lookups, client, all.size());
    step.place = place.number;
    step.number = reads;
    step.scopes = chunk_->add_scopes(place);
    step.x = place.x;
    step.y = place.y;
    chunk_->steps_.push_back(step);
    hand_over_full();
}

void LookupChunker::flush(work::LookupClient client) {
    chunk_->steps_.push_back(chunk_->step(LookupChunk::Kind::Flush, client, 0));
    hand_over_full();
}

void LookupChunker::overwritten(work::LookupClient client,
                                std::span<const work::OverwrittenLine> lines) {
    auto& all = chunk_->overwritten_;
    all.insert(all.end(), lines.begin(), lines.end());
    chunk_->steps_.push_back(chunk_->step(LookupChunk::Kind::Overwritten, client, all.size()));
    hand_over_full();
}

void LookupChunker::end_frame(std::uint32_t frame) {
    LookupChunk::Step step = chunk_->step(LookupChunk::Kind::EndFrame, {}, 0);
    step.number = frame;
    chunk_->steps_.push_back(step);
    hand_over_full();
}

} // namespace ffgpu::tools
