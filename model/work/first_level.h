// FirstLevel: a texel cache of one shape in front of others: its misses are what they look up, by
// the bytes that memory has of a line. All else passes.

#pragma once

#include "model/work/lookups.h"
#include "model/work/tag_array.h"
#include "model/work/texel_line.h"

#include <cstdint>
#include <vector>

namespace ffgpu::work {

class FirstLevel final : public LookupSink {
public:
    FirstLevel(std::uint32_t sets, std::uint32_t ways, std::uint32_t line_bytes, LookupSink& out)
        : line_bytes_(line_bytes)
        , tags_(sets, ways)
        , out_(out) {}

    // A miss is a look-up of its own, also where the quad's miss before it is of the same line.
    void lookups(LookupClient client,
                 const LookupPlace& place,
                 std::span<const LineLookup> lines,
                 std::uint32_t reads) override {
        if (client != LookupClient::Texel) return out_.lookups(client, place, lines, reads);
        for (const LineLookup& lookup : lines) {
            if (const TagArray::Line* const line = tags_.find(lookup.line)) {
                tags_.use(*line);
                continue;
            }
            TagArray::Evicted evicted;
            tags_.replace(lookup.line, evicted);
            const std::uint64_t address = line_source(lookup.line, line_bytes_).address;
            const LineLookup miss{quotient(address, line_bytes_), false};
            out_.lookups(client, place, {&miss, 1}, 1);
        }
    }
    void flush(LookupClient client) override { out_.flush(client); }
    // Lines of expanded texels follow each other as their blocks do.
    void overwritten(LookupClient client, std::span<const OverwrittenLine> lines) override {
        if (client != LookupClient::Texel) return out_.overwritten(client, lines);
        std::vector<OverwrittenLine> behind;
        for (const OverwrittenLine& overwritten : lines) {
            if (TagArray::Line* const line = tags_.find(overwritten.line)) tags_.drop(*line);
            const std::uint64_t address = line_source(overwritten.line, line_bytes_).address;
            const std::uint64_t number = quotient(address, line_bytes_);
            if (behind.empty() || behind.back().line != number) behind.push_back({number, true});
        }
        out_.overwritten(client, behind);
    }
    void end_frame(std::uint32_t frame) override { out_.end_frame(frame); }

private:
    const std::uint32_t line_bytes_;
    TagArray tags_;
    LookupSink& out_;
};

} // namespace ffgpu::work
