// Look-ups in chunks, for readers on other threads.

#pragma once

#include "model/work/lookups.h"

#include <functional>
#include <memory>
#include <vector>

namespace ffgpu::tools {

class LookupChunk {
public:
    void play(work::LookupSink& sink) const;
    std::size_t weight() const { return lookups_.size() + overwritten_.size() + steps_.size(); }

private:
    friend class LookupChunker;
    enum class Kind : std::uint8_t { Lookups, Flush, Overwritten, EndFrame };
    struct Step {
        Kind kind = Kind::Lookups;
        work::LookupClient client = work::LookupClient::Texel;
        std::uint32_t number = 0; // reads, or the frame
        std::size_t end = 0;      // of its look-ups or lines, which begin where those before end
        work::LookupPlace place{};
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
    static constexpr std::size_t Weight = std::size_t{1} << 15;

    void hand_over_full();

    HandOver hand_over_;
    std::shared_ptr<LookupChunk> chunk_ = std::make_shared<LookupChunk>();
};

} // namespace ffgpu::tools
