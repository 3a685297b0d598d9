#include "tools/report/series_file.h"

#include "model/base/whole_file.h"

#include <filesystem>

#include <fmt/format.h>

namespace ffgpu::tools {

void SeriesFile::columns(std::span<const timing::SeriesColumn> columns) {
    head_ = "frame,begin_cycle,cycles";
    for (const timing::SeriesColumn& column : columns)
        head_.append(",").append(column.name);
    head_ += '\n';
}

void SeriesFile::sample(const timing::SeriesSample& sample) {
    rows_.push_back(
        fmt::format(",{},{},{}\n", sample.begin, sample.cycles, fmt::join(sample.counts, ",")));
}

void SeriesFile::end_frame(std::uint32_t frame) {
    for (const std::string& row : rows_)
        frames_.append(std::to_string(frame) + row);
    rows_.clear();
}

void SeriesFile::write(const std::string& folder) const {
    WholeFile file((std::filesystem::path(folder) / "series.csv").string());
    file.write(head_);
    frames_.copy_to([&file](std::string_view text) { file.write(text); });
    file.commit();
}

} // namespace ffgpu::tools
