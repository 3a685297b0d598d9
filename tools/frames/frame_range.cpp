#include "tools/frames/frame_range.h"

#include "model/base/input_error.h"

#include <charconv>

#include <fmt/format.h>

namespace ffgpu::tools {

FrameRange parse_frame_range(const std::string& text, const std::string& option) {
    const auto wrong = [&] {
        return InputError(option + " " + text + ": expected A-B, A or A-, with A not above B");
    };
    FrameRange range;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, range.first);
    if (first.ec != std::errc()) throw wrong();
    if (first.ptr == end) {
        range.last = range.first;
        return range;
    }
    if (*first.ptr != '-') throw wrong();
    if (first.ptr + 1 == end) return range;
    const auto last = std::from_chars(first.ptr + 1, end, range.last);
    if (last.ec != std::errc() || last.ptr != end || range.last < range.first) throw wrong();
    return range;
}

std::string
missing_frames(const FrameRange& wanted, const std::string& source, std::uint64_t count) {
    const std::string has = fmt::format("--frames: {} ends before frame {}", source, count);
    if (count <= wanted.first && wanted.first > 0)
        return has + ": none of those asked for is there";
    if (count <= wanted.last && wanted.last != FrameRange{}.last)
        return fmt::format("{}, {} was asked for", has, wanted.last);
    return {};
}

} // namespace ffgpu::tools
