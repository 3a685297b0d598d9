#include "tools/diff/account_lines.h"

#include <iterator>

namespace ffgpu::tools {

void AccountLines::begin(AccountPart part, const AccountPlace& place) {
    is_wanted_ = wanted_[part.index()];
    if (!is_wanted_) return;
    line_.clear();
    fmt::format_to(std::back_inserter(line_), "{}\t{}", part_name(part), place_name(place));
}

void AccountLines::name(std::string_view field, int index) {
    if (index < 0)
        fmt::format_to(std::back_inserter(line_), "\t{}=", field);
    else
        fmt::format_to(std::back_inserter(line_), "\t{}[{}]=", field, index);
}

void AccountLines::integer(std::string_view field, std::int64_t value, int index) {
    if (!is_wanted_) return;
    name(field, index);
    fmt::format_to(std::back_inserter(line_), "{}", value);
}

void AccountLines::real(std::string_view field, double value, int index) {
    if (!is_wanted_) return;
    name(field, index);
    fmt::format_to(std::back_inserter(line_), "{}", value); // as short as reads back the same
}

void AccountLines::color(std::string_view field, std::uint32_t rgba8, int index) {
    if (!is_wanted_) return;
    name(field, index);
    fmt::format_to(std::back_inserter(line_),
                   "{:02x}{:02x}{:02x}{:02x}",
                   rgba8 & 0xff,
                   rgba8 >> 8 & 0xff,
                   rgba8 >> 16 & 0xff,
                   rgba8 >> 24);
}

void AccountLines::text(std::string_view field, std::string_view value) {
    if (!is_wanted_) return;
    name(field, -1);
    line_.append(value.data(), value.data() + value.size());
}

void AccountLines::end() {
    if (!is_wanted_) return;
    line_.push_back('\n');
    std::fwrite(line_.data(), 1, line_.size(), out_);
}

} // namespace ffgpu::tools
