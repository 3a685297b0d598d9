#include "tools/config/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ffgpu::tools {
namespace {

// Levenshtein's distance, a row at a time.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row[b.size()];
}

} // namespace

std::string nearest_name(std::string_view typed, const std::vector<std::string>& names) {
    return *std::ranges::min_element(
        names, {}, [&](const std::string& name) { return distance(typed, name); });
}

} // namespace ffgpu::tools
