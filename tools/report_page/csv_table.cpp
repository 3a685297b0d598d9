#include "tools/report_page/csv_table.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t begin = 0;;) {
        const std::size_t end = line.find(',', begin);
        cells.push_back(line.substr(begin, end - begin));
        if (end == std::string_view::npos) return cells;
        begin = end + 1;
    }
}

} // namespace

std::optional<CsvTable> CsvTable::read(const std::string& path) {
    if (!std::filesystem::exists(path)) return std::nullopt;
    return CsvTable(path);
}

CsvTable::CsvTable(const std::string& path)
    : path_(path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw InputError(path + ": cannot be read");
    text_ = std::make_shared<const std::string>(std::move(text).str());
    cut(*text_);
}

void CsvTable::cut(std::string_view text) {
    std::size_t line = 0;
    for (std::size_t begin = 0; begin < text.size(); ++line) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string_view::npos)
            throw InputError(fmt::format("{}: line {} is cut off", path_, line + 1));
        const auto cells = cells_of(text.substr(begin, end - begin));
        if (line == 0)
            names_ = cells;
        else if (cells.size() != names_.size())
            throw InputError(fmt::format("{}: line {} has {} values, expected {}",
                                         path_,
                                         line + 1,
                                         cells.size(),
                                         names_.size()));
        else
            values_.insert(values_.end(), cells.begin(), cells.end());
        begin = end + 1;
    }
    if (names_.empty()) throw InputError(path_ + ": is empty");
}

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
}

std::size_t CsvTable::wanted_column(std::string_view name) const {
    const std::optional<std::size_t> found = column(name);
    if (!found) throw InputError(fmt::format("{}: has no column {}", path_, name));
    return *found;
}

std::uint64_t CsvTable::number(std::size_t row, std::size_t column) const {
    const std::string_view cell = text(row, column);
    std::uint64_t number = 0;
    const char* const end = cell.data() + cell.size();
    const auto [at, error] = std::from_chars(cell.data(), end, number);
    if (error != std::errc() || at != end)
        throw InputError(
            fmt::format("{}: line {}, {}: expected a number", path_, row + 2, names_[column]));
    return number;
}

} // namespace ffgpu::tools
