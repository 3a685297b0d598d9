#include "tools/export/din_writer.h"

#include "model/base/input_error.h"
#include "model/work/texel_line.h"

namespace ffgpu::tools {
namespace {

constexpr unsigned ExpansionInAddress = 48; // expanded lines lie apart from memory's

} // namespace

std::uint64_t DinWriter::address(std::uint64_t line) const {
    constexpr std::uint64_t Low = (std::uint64_t{1} << work::ExpansionAt) - 1;
    return (line & Low) * line_bytes_ | std::uint64_t{work::expansion_of(line)}
                                            << ExpansionInAddress;
}

void DinWriter::lookups(work::LookupClient client,
                        const work::LookupPlace&,
                        std::span<const work::LineLookup> lines,
                        std::uint32_t) {
    if (client != client_) return;
    for (const work::LineLookup& lookup : lines) {
        if (client != work::LookupClient::Texel) touched_.insert(lookup.line);
        if (extended_)
            out_.print(FMT_COMPILE("{} {:x} {:x}\n"),
                       lookup.write ? 'w' : 'r',
                       address(lookup.line),
                       line_bytes_);
        else
            out_.print(FMT_COMPILE("{} {:x}\n"), lookup.write ? '1' : '0', address(lookup.line));
    }
    records_ += lines.size();
}

// Written back and forgotten.
void DinWriter::flush(work::LookupClient client) {
    if (client != client_ || touched_.empty()) return;
    touched_.clear();
    if (extended_)
        out_.print(FMT_COMPILE("c 0 0\nv 0 0\n"));
    else
        out_.print(FMT_COMPILE("4 0\n"));
}

void DinWriter::overwritten(work::LookupClient client,
                            std::span<const work::OverwrittenLine> lines) {
    if (client != client_) return;
    for (const work::OverwrittenLine& line : lines) {
        const bool texel = client == work::LookupClient::Texel;
        if (!texel && touched_.erase(line.line) == 0) continue;
        if (!extended_)
            throw InputError(
                fmt::format("--format din: frame {} overwrites lines of the {} cache "
                            "past it, which din has no word for: xdin has{}",
                            frame_,
                            work::LookupClientNames[static_cast<std::size_t>(client)],
                            texel ? "; or --set texel_cache.rewritten=new_place" : ""));
        const std::uint64_t at = address(line.line);
        if (!line.whole) out_.print(FMT_COMPILE("c {:x} {:x}\n"), at, line_bytes_);
        out_.print(FMT_COMPILE("v {:x} {:x}\n"), at, line_bytes_);
    }
}

} // namespace ffgpu::tools
