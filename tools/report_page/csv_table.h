// CsvTable: a file of comma-separated values as ffgpu writes them: a line of names, then lines of
// as many values, none of which holds a comma or a quote.

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

class CsvTable {
public:
    // Nothing: there is no such file. Throws InputError where it is damaged.
    static std::optional<CsvTable> read(const std::string& path);

    const std::vector<std::string_view>& names() const { return names_; }
    std::size_t rows() const { return names_.empty() ? 0 : values_.size() / names_.size(); }

    // Nothing: there is none of this name.
    std::optional<std::size_t> column(std::string_view name) const;
    // Throws InputError.
    std::size_t wanted_column(std::string_view name) const;

    std::string_view text(std::size_t row, std::size_t column) const {
        return values_[row * names_.size() + column];
    }
    // Throws InputError where it is none.
    std::uint64_t number(std::size_t row, std::size_t column) const;

private:
    explicit CsvTable(const std::string& path);
    void cut(std::string_view text);

    std::string path_;
    std::shared_ptr<const std::string> text_;
    std::vector<std::string_view> names_, values_; // in text_
};

} // namespace ffgpu::tools
