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

bool LookupChunker::are_again(std::span<const work::LineLookup> lines) const {
    const std::vector<LookupChunk::Step>& steps = chunk_->steps_;
    if (steps.empty() || !steps.back().is_of_texels() || lines.size() != last_lines_) return false;
    const auto before = chunk_->lookups_.end() - static_cast<std::ptrdiff_t>(last_lines_);
    return std::equal(lines.begin(), lines.end(), before);
}

void LookupChunker::add_again(std::uint32_t reads) {
    using Kind = LookupChunk::Kind;
    constexpr std::uint32_t MostReads = std::numeric_limits<std::uint32_t>::max();
    LookupChunk::Step& last = chunk_->steps_.back();
    if (last.kind == Kind::Again && last.number <= MostReads - reads) {
        ++last.quads;
        last.number += reads;
        return;
    }
    LookupChunk::Step& step = add(Kind::Again);
    step.number = reads;
    step.end = static_cast<std::uint32_t>(chunk_->lookups_.size());
    step.since = work::Reuse::Tile;
}

void LookupChunker::lookups(work::LookupClient client,
                            const work::LookupPlace& place,
                            std::span<const work::LineLookup> lines,
                            std::uint32_t reads) {
    auto& last = client == work::LookupClient::Vertex ? last_vertex_ : last_quad_;
    const work::Reuse since = last ? place.since(*last) : work::Reuse::EarlierFrame;
    last = place.number;
    if (client == work::LookupClient::Texel && since == work::Reuse::Tile && are_again(lines))
        return add_again(reads);
    make_room();
    auto& all = chunk_->lookups_;
    for (const work::LineLookup& line : lines) // Few: to move a range takes longer.
        all.push_back(line);
    last_lines_ = lines.size();
    LookupChunk::Step& step = add(LookupChunk::Kind::Lookups);
    step.number = reads;
    step.end = static_cast<std::uint32_t>(all.size());
    step.client = client;
    step.since = since;
}

void LookupChunker::same_lookups(const work::LookupPlace& place,
                                 std::span<const work::LineLookup> lines,
                                 std::uint32_t reads) {
    if (chunk_->steps_.empty() || !chunk_->steps_.back().is_of_texels())
        return lookups(work::LookupClient::Texel, place, lines, reads);
    last_quad_ = place.number;
    add_again(reads);
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
