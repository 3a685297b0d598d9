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
    using Scopes = decltype(work::LookupPlace::began);
    struct Step {
        std::uint64_t place = 0;  // LookupPlace::number
        std::uint32_t number = 0; // reads, or the frame
        std::uint32_t end = 0;    // of its look-ups or lines, which begin where those before end
        std::uint32_t scopes = 0; // in scopes_
        std::uint16_t x = 0, y = 0;
        Kind kind = Kind::Lookups;
        work::LookupClient client = work::LookupClient::Texel;
    };

    Step step(Kind kind, work::LookupClient client, std::size_t end) const;
    std::uint32_t add_scopes(const work::LookupPlace& place);
    work::LookupPlace place_of(const Step& step) const;

    std::vector<Step> steps_;
    std::vector<Scopes> scopes_; // few: most places share all but the first, which is their own
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
