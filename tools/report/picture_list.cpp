#include "tools/report/picture_list.h"

#include "model/base/whole_file.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

std::uint64_t figure(const work::Figures& figures, std::string_view name) {
    const auto found = std::find_if(
        figures.begin(), figures.end(), [&](const auto& one) { return one.first == name; });
    return found == figures.end() ? 0 : found->second;
}

} // namespace

void PictureList::add(const work::FrameFigures& frame, const std::vector<std::string>& pictures) {
    Row row{.frame = frame.number,
            .covered = figure(frame.functional, "fragments_covered"),
            .written = figure(frame.functional, "fragments_written"),
            .pictures = fmt::format("{}", fmt::join(pictures, " "))};
    const std::lock_guard lock(mutex_);
    untimed_.push_back(std::move(row));
}

void PictureList::timed(std::uint64_t cycles) {
    const std::lock_guard lock(mutex_);
    const Row& row = untimed_.front();
    rows_.append(
        fmt::format("{},{},{},{},{}\n", row.frame, row.covered, row.written, cycles, row.pictures));
    untimed_.pop_front();
}

void PictureList::write(const std::string& folder) const {
    WholeFile file((std::filesystem::path(folder) / PictureListName).string());
    file.write("frame,fragments_covered,fragments_written,total_cycles,pictures\n");
    const std::lock_guard lock(mutex_);
    rows_.copy_to([&file](std::string_view text) { file.write(text); });
    file.commit();
}

} // namespace ffgpu::tools
