// Look-ups in chunks, for readers on other threads.

#pragma once

#include "model/work/lookups.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ffgpu::tools {

// The places of quads and of vertices, which are numbered apart, as a chunk's reader has come to
// them: numbers and window pixels are not those of the writer's, what was looked up in the same
// quad, tile, primitive ... is.
struct LookupPlaces {
    work::LookupPlace quad, vertex;

    work::LookupPlace& of(work::LookupClient client) {
        return client == work::LookupClient::Vertex ? vertex : quad;
    }
};

class LookupChunk {
public:
    // `places`: those at the end of the chunk before; at first any.
    void play(work::LookupSink& sink, LookupPlaces& places) const;
    std::size_t weight() const { return lookups_.size() + overwritten_.size() + steps_.size(); }

private:
    friend class LookupChunker;
    enum class Kind : std::uint8_t { Lookups, Flush, Overwritten, EndFrame };
    struct Step {
        std::uint32_t number = 0; // reads, or the frame
        std::uint32_t end = 0;    // of its look-ups or lines, which begin where those before end
        Kind kind = Kind::Lookups;
        work::LookupClient client = work::LookupClient::Texel;
        work::Reuse since = work::Reuse::Quad; // the place told before, as seen from this one
    };

    std::vector<Step> steps_;
    std::vector<work::LineLookup> lookups_;
    std::vector<work::OverwrittenLine> overwritten_;
};

class LookupChunker final : public work::LookupSink {
public:
    using HandOver = std::function<void(std::shared_ptr<const LookupChunk>)>;
    explicit LookupChunker(HandOver hand_over)
        : hand_over_(std::move(hand_over)) {}

    void lookups(work::LookupClient client,
                 const work::LookupPlace& place,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t reads) override;
    void flush(work::LookupClient client) override;
    void overwritten(work::LookupClient client,
                     std::span<const work::OverwrittenLine> lines) override;
    void end_frame(std::uint32_t frame) override;

    // Hands over what is left.
    void finish();

private:
    static constexpr std::size_t Weight = std::size_t{1} << 14;

    void add(const LookupChunk::Step& step);

    HandOver hand_over_;
    // Of the place told before, of quads and of vertices.
    std::optional<std::uint64_t> last_quad_, last_vertex_;
    std::shared_ptr<LookupChunk> chunk_ = std::make_shared<LookupChunk>();
};

} // namespace ffgpu::tools
