#include "tools/record/output_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::array Extensions{".png", ".npy", ".svg"};

// frame_0000.png, heat_cycles_0000.npy ...
bool is_picture_of(std::span<const std::string_view> prefixes, const fs::path& name) {
    const std::string stem = name.stem().string();
    const bool has_prefix = std::ranges::any_of(
        prefixes, [&](std::string_view prefix) { return stem.starts_with(prefix); });
    const bool is_picture = std::ranges::find(Extensions, name.extension()) != Extensions.end();
    return has_prefix && is_picture && std::isdigit(static_cast<unsigned char>(stem.back())) != 0;
}

} // namespace

OutputFolder::OutputFolder(std::string path, std::span<const std::string_view> prefixes)
    : path_(std::move(path))
    , made_(path_) {
    if (path_.empty()) return;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(path_, error))
        if (is_picture_of(prefixes, entry.path().filename()))
            older_.insert(entry.path().filename().string());
}

std::string
OutputFolder::picture(std::string_view prefix, std::uint64_t frame, std::string_view extension) {
    return file(fmt::format("{}_{:04}.{}", prefix, frame, extension));
}

std::string OutputFolder::file(const std::string& name) {
    older_.erase(name);
    return (fs::path(path_) / name).string();
}

std::string OutputFolder::older_pictures() const {
    if (older_.empty()) return {};
    return fmt::format("{}: holds {} of an older run, too, {} to {}: its statistics are not those",
                       path_,
                       older_.size() == 1 ? "a picture" : fmt::format("{} pictures", older_.size()),
                       *older_.begin(),
                       *older_.rbegin());
}

} // namespace ffgpu::tools
