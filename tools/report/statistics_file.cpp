#include "tools/report/statistics_file.h"

#include "model/base/input_error.h"
#include "tools/files/whole_file.h"

#include <filesystem>

namespace ffgpu::tools {

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw InputError(path + ": cannot be made: " + error.message());
}

void write_statistics_file(const StatisticsReport& report, const std::string& folder) {
    const auto path = (std::filesystem::path(folder) / "stats.json").string();
    WholeFile file(path);
    report.write([&file](std::string_view text) { file.write(text); });
    file.commit();
}

} // namespace ffgpu::tools
