#include "tools/files/made_folder.h"

#include "model/base/input_error.h"

namespace ffgpu::tools {

namespace fs = std::filesystem;

MadeFolder::MadeFolder(const std::string& path) {
    if (path.empty()) return;
    std::error_code error;
    // One that ends in a slash is its own parent.
    for (fs::path part = fs::absolute(path).lexically_normal(); part != part.parent_path();
         part = part.parent_path()) {
        if (fs::exists(part, error)) break;
        if (part.has_filename()) made_.push_back(part);
    }
    fs::create_directories(path, error);
    if (error) throw InputError(path + ": cannot be made: " + error.message());
}

MadeFolder::~MadeFolder() {
    std::error_code error;
    for (const fs::path& folder : made_) {
        if (!fs::is_empty(folder, error) || error) return;
        fs::remove(folder, error);
    }
}

} // namespace ffgpu::tools
