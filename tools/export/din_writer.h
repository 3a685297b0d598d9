// DinWriter: the look-ups of one client, as Dinero reads them: its formats din (Dinero III) and
// extended din (Dinero IV; J. Edler, M. D. Hill). A look-up that reads and writes is a write.

#pragma once

#include "model/work/lookups.h"
#include "tools/export/text_writer.h"

#include <cstdint>
#include <unordered_set>

namespace ffgpu::tools {

class DinWriter final : public work::LookupSink {
public:
    enum class Form : std::uint8_t { Din, Extended };

    DinWriter(Form form, work::LookupClient client, std::uint32_t line_bytes, TextWriter& out)
        : extended_(form == Form::Extended)
        , client_(client)
        , line_bytes_(line_bytes)
        , out_(out) {}

    void lookups(work::LookupClient client,
                 const work::LookupPlace& place,
                 std::span<const work::LineLookup> lines,
                 std::uint32_t reads) override;
    void flush(work::LookupClient client) override;
    // Throws InputError where the format has no word for it.
    void overwritten(work::LookupClient client,
                     std::span<const work::OverwrittenLine> lines) override;
    void end_frame(std::uint32_t frame) override { frame_ = frame + 1; }

    std::uint64_t written() const { return records_; } // look-ups

private:
    std::uint64_t address(std::uint64_t line) const;

    const bool extended_;
    const work::LookupClient client_;
    const std::uint32_t line_bytes_;
    TextWriter& out_;
    std::uint64_t records_ = 0;
    std::uint32_t frame_ = 0;
    // Since the last flush: what a cache may hold. Of texels it is not asked: those that are
    // overwritten have been read, or lie beside such.
    std::unordered_set<std::uint64_t> touched_;
};

} // namespace ffgpu::tools
