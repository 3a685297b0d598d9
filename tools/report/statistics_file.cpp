#include "tools/report/statistics_file.h"

#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "tools/report/picture_list.h"

#include <filesystem>

namespace ffgpu::tools {
namespace {

std::string path_in(const std::string& folder) {
    return (std::filesystem::path(folder) / "stats.json").string();
}

} // namespace

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw InputError(path + ": cannot be made: " + error.message());
}

void write_statistics_file(const StatisticsReport& report, const std::string& folder) {
    WholeFile file(path_in(folder));
    report.write([&file](std::string_view text) { file.write(text); });
    file.commit();
}

void write_totals_file(const StatisticsReport& report, const std::string& path, bool is_stuck) {
    if (path.empty()) return;
    std::string text;
    report.write([&text](std::string_view piece) {
        if (text.empty()) text = piece;
    });
    WholeFile file(path);
    file.write(is_stuck ? "{\n \"stuck\": true," : "{");
    file.write(text.substr(1) + "\n}\n");
    file.commit();
}

void remove_statistics_files(const std::string& folder) {
    std::error_code ignored;
    std::filesystem::remove(path_in(folder), ignored);
    std::filesystem::remove(std::filesystem::path(folder) / PictureListName, ignored);
}

} // namespace ffgpu::tools
