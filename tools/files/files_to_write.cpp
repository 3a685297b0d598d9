#include "tools/files/files_to_write.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

// Where it leads; nothing for what is no file: a terminal, or the standard output.
std::optional<fs::path> place_of(const std::string& path) {
    if (path.empty() || path == "-") return std::nullopt;
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(path), error);
    if (error || fs::is_character_file(place, error)) return std::nullopt;
    return place;
}

// Of all that goes to folders.
constexpr std::array Extensions{".csv", ".json", ".npy", ".png", ".svg"};

bool is_of_folder(const fs::path& file) {
    return std::ranges::find(Extensions, file.extension()) != Extensions.end();
}

void check_folder(const std::string& read, const std::string& folder) {
    const auto file = place_of(read), where = place_of(folder);
    if (!file || !where) return;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator((*where / "").parent_path(), error)) {
        if (!is_of_folder(entry.path())) continue;
        const bool is_link = entry.is_symlink(error);
        if ((is_link ? fs::weakly_canonical(entry.path(), error) : entry.path()) != *file) continue;
        throw InputError(fmt::format(
            "-o {}: holds the input {}, which may be written over: expected another folder, or a "
            "name that does not end in {}",
            folder,
            read,
            entry.path().extension().string()));
    }
}

} // namespace

void check_folder(std::initializer_list<std::string> read, const std::string& folder) {
    for (const std::string& file : read)
        check_folder(file, folder);
}

void check_outside(const char* option, const std::string& path, const std::string& folder) {
    const auto file = place_of(path), where = place_of(folder);
    if (!file || !where || !is_of_folder(*file) ||
        file->parent_path() != (*where / "").parent_path())
        return;
    throw InputError(fmt::format("{} {}: may be a file of {}: expected another folder, or a name "
                                 "that does not end in {}",
                                 option,
                                 path,
                                 folder,
                                 file->extension().string()));
}

void check_files(std::initializer_list<std::string> read,
                 std::initializer_list<FileToWrite> written) {
    std::map<fs::path, const char*> seen; // null: it is read
    for (const std::string& path : read)
        if (const auto place = place_of(path)) seen.emplace(*place, nullptr);
    for (const FileToWrite& file : written) {
        const auto place = place_of(file.path);
        if (!place) continue;
        std::error_code error;
        if (fs::is_directory(*place, error))
            throw InputError(
                fmt::format("{} {}: is a folder; a file was expected", file.option, file.path));
        const auto [other, is_first] = seen.emplace(*place, file.option);
        if (is_first) continue;
        if (!other->second)
            throw InputError(fmt::format(
                "{} {}: is the input, which would be written over", file.option, file.path));
        throw InputError(
            fmt::format("{}: is both {}'s and {}'s file", file.path, other->second, file.option));
    }
}

} // namespace ffgpu::tools
