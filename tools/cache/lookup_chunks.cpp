#include "tools/cache/lookup_chunks.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ffgpu::tools {

void LookupChunk::play(ChunkReader& reader, LookupPlaces& places) const {
    std::size_t lookup = 0, line = 0;
    std::span<const work::LineLookup> last;
    for (const Step& step : steps_) {
        switch (step.kind) {
        case Kind::Lookups: {
            work::LookupPlace& place = places.of(step.client);
            if (step.since != work::Reuse::Quad) {
                ++place.number;
                place.begin(static_cast<work::Reuse>(static_cast<unsigned>(step.since) - 1));
            }
            last = std::span(lookups_).subspan(lookup, step.end - lookup);
            reader.lookups(step.client, place, last, step.number);
            lookup = step.end;
            break;
        }
        case Kind::Again:
            places.quad.number += step.quads;
            places.quad.begin(work::Reuse::Quad);
            reader.lookups_again(places.quad, last, step.quads, step.number);
            break;
        case Kind::Flush:
            reader.flush(step.client);
            break;
        case Kind::Overwritten:
            reader.overwritten(step.client, std::span(overwritten_).subspan(line, step.end - line));
            line = step.end;
            break;
        case Kind::EndFrame:
            reader.end_frame(step.number);
        }
    }
}

LookupChunk::Step& LookupChunker::add(LookupChunk::Kind kind) {
    LookupChunk::Step& step = chunk_->steps_.emplace_back();
    step.kind = kind;
    return step;
}

void LookupChunker::make_room() {
    if (chunk_->weight() >= Weight) finish();
}

void LookupChunker::finish() {
    if (chunk_->weight() > 0) hand_over_(std::exchange(chunk_, std::make_shared<LookupChunk>()));
}

bool LookupChunker::add_again(std::span<const work::LineLookup> lines, std::uint32_t reads) {
    using Kind = LookupChunk::Kind;
    std::vector<LookupChunk::Step>& steps = chunk_->steps_;
    if (steps.empty() || steps.back().client != work::LookupClient::Texel) return false;
    const Kind kind = steps.back().kind;
    if (kind != Kind::Lookups && kind != Kind::Again) return false;
    if (lines.size() != last_lines_ ||
        !std::equal(lines.begin(),
                    lines.end(),
                    chunk_->lookups_.end() - static_cast<std::ptrdiff_t>(last_lines_)))
        return false;
    constexpr std::uint32_t MostReads = std::numeric_limits<std::uint32_t>::max();
    if (kind == Kind::Again && steps.back().number <= MostReads - reads) {
        ++steps.back().quads;
        steps.back().number += reads;
    } else {
        LookupChunk::Step& step = add(Kind::Again);
        step.number = reads;
        step.end = static_cast<std::uint32_t>(chunk_->lookups_.size());
        step.since = work::Reuse::Tile;
    }
    return true;
}

void LookupChunker::lookups(work::LookupClient client,
                            const work::LookupPlace& place,
                            std::span<const work::LineLookup> lines,
                            std::uint32_t reads) {
    auto& last = client == work::LookupClient::Vertex ? last_vertex_ : last_quad_;
    const work::Reuse since = last ? place.since(*last) : work::Reuse::EarlierFrame;
    last = place.number;
    if (client == work::LookupClient::Texel && since == work::Reuse::Tile &&
        add_again(lines, reads))
        return;
    make_room();
    auto& all = chunk_->lookups_;
    all.insert(all.end(), lines.begin(), lines.end());
    last_lines_ = lines.size();
    LookupChunk::Step& step = add(LookupChunk::Kind::Lookups);
    step.number = reads;
    step.end = static_cast<std::uint32_t>(all.size());
    step.client = client;
    step.since = since;
}

void LookupChunker::flush(work::LookupClient client) {
    make_room();
    add(LookupChunk::Kind::Flush).client = client;
}

void LookupChunker::overwritten(work::LookupClient client,
                                std::span<const work::OverwrittenLine> lines) {
    make_room();
    auto& all = chunk_->overwritten_;
    all.insert(all.end(), lines.begin(), lines.end());
    LookupChunk::Step& step = add(LookupChunk::Kind::Overwritten);
    step.end = static_cast<std::uint32_t>(all.size());
    step.client = client;
}

void LookupChunker::end_frame(std::uint32_t frame) {
    make_room();
    add(LookupChunk::Kind::EndFrame).number = frame;
}

} // namespace ffgpu::tools
