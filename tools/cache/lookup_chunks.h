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

class ChunkReader : public work::LookupSink {
public:
    // Texels' look-ups that were told last, once more by each of the `quads` up to `place`, all of
    // one tile. `reads`: of all of them.
    virtual void lookups_again(const work::LookupPlace& place,
                               std::span<const work::LineLookup> lines,
                               std::uint32_t quads,
                               std::uint32_t reads) = 0;
};

class LookupChunk {
public:
    // `places`: those at the end of the chunk before; at first any.
    void play(ChunkReader& reader, LookupPlaces& places) const;
    std::size_t weight() const { return lookups_.size() + overwritten_.size() + steps_.size(); }

private:
    friend class LookupChunker;
    enum class Kind : std::uint8_t { Lookups, Again, Flush, Overwritten, EndFrame };
    struct Step {
        std::uint32_t number = 0; // reads, or the frame
        std::uint32_t end = 0;    // of its look-ups or lines, which begin where those before end
        std::uint32_t quads = 1;  // of Again, whose look-ups are those of the step before
        Kind kind = Kind::Lookups;
        work::LookupClient client = work::LookupClient::Texel;
        work::Reuse since = work::Reuse::Quad; // the place told before, as seen from this one

        bool is_of_texels() const {
            return client == work::LookupClient::Texel &&
                   (kind == Kind::Lookups || kind == Kind::Again);
        }
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
    void same_lookups(const work::LookupPlace& place,
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

    // A step, to be filled in its place.
    LookupChunk::Step& add(LookupChunk::Kind kind);
    // Before more is added: hands over what is heavy enough.
    void make_room();
    // Whether the step before tells of such look-ups of texels.
    bool are_again(std::span<const work::LineLookup> lines) const;
    // One quad more that looks up what the step before tells of.
    void add_again(std::uint32_t reads);

    HandOver hand_over_;
    // Of the place told before, of quads and of vertices.
    std::optional<std::uint64_t> last_quad_, last_vertex_;
    std::size_t last_lines_ = 0; // of the look-ups told last
    std::shared_ptr<LookupChunk> chunk_ = std::make_shared<LookupChunk>();
};

} // namespace ffgpu::tools
