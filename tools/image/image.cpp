#include "tools/image/image.h"

#include "model/base/input_error.h"
#include "tools/files/library_folder.h"
#include "tools/image/picture_formats.h"
#include "tools/image/png_file.h"

#include <filesystem>

#include <dlfcn.h>

namespace ffgpu::tools {
namespace {

// OpenImageIO with all that it brings, loaded where a picture is no PNG.
ReadPicture load_picture_reader(const std::string& path) {
    const std::string library = library_path("ffgpu_pictures.so").string();
    void* const handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = handle ? ::dlsym(handle, ReadPictureName) : nullptr;
    if (!symbol)
        throw InputError(path + ": is no PNG, and what reads other pictures is not there: " +
                         std::string(::dlerror()));
    return reinterpret_cast<ReadPicture>(symbol);
}

} // namespace

Image read_image(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw InputError(path + ": " + (error ? error.message() : "does not exist"));
    if (std::filesystem::is_other(path, error)) // It is read from its beginning more than once.
        throw InputError(path + ": is a pipe or a device; a file was expected");
    if (is_png(path)) return read_png(path);
    static const ReadPicture read = load_picture_reader(path);
    Image image;
    std::string why;
    if (!read(path, image, why)) throw InputError(path + ": " + why);
    return image;
}

} // namespace ffgpu::tools
