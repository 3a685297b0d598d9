#include "tools/image/png_file.h"

#include "model/base/input_error.h"
#include "model/base/whole_file.h"

#include <array>
#include <fstream>
#include <string_view>

#include <png.h>

namespace ffgpu::tools {
namespace {

constexpr std::size_t Rgba = 4;

// libpng's control structure, freed in the end.
struct Control : png_image {
    Control()
        : png_image{} {
        version = PNG_IMAGE_VERSION;
    }
    ~Control() { png_image_free(this); }
    Control(const Control&) = delete;
    Control& operator=(const Control&) = delete;
};

[[noreturn]] void fail(const Control& control, const std::string& path) {
    throw InputError(path + ": is a damaged PNG: " + std::string(control.message));
}

// Of a file that was begun.
Image pixels_of(Control& control, const std::string& path) {
    if (std::size_t{control.width} * control.height > MaxImagePixels)
        throw InputError(path + ": its size is not that of a picture");
    control.format = PNG_FORMAT_RGBA;
    control.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    Image image(control.width, control.height);
    std::vector<png_byte> pixels(Rgba * image.pixels());
    if (!png_image_finish_read(&control, nullptr, pixels.data(), 0, nullptr)) fail(control, path);
    for (std::size_t i = 0; i < image.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.rgb[3 * i + c] = pixels[Rgba * i + c];
    return image;
}

} // namespace

bool is_png(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 8> signature{};
    file.read(signature.data(), signature.size());
    return file &&
           png_sig_cmp(reinterpret_cast<png_const_bytep>(signature.data()), 0, signature.size()) ==
               0;
}

Image read_png(const std::string& path) {
    Control control;
    if (!png_image_begin_read_from_file(&control, path.c_str())) fail(control, path);
    return pixels_of(control, path);
}

Image read_whole_png(const std::string& content, const std::string& path) {
    using namespace std::string_view_literals;
    // The last chunk with its checksum, which libpng does not read: it ends behind the pixels.
    constexpr std::string_view End = "\0\0\0\0IEND\xae\x42\x60\x82"sv;
    if (!content.starts_with("\x89PNG\r\n\x1a\n")) throw InputError(path + ": is no PNG");
    Control control;
    if (!png_image_begin_read_from_memory(&control, content.data(), content.size()))
        fail(control, path);
    Image image = pixels_of(control, path);
    if (control.warning_or_error != 0) fail(control, path); // As of a checksum beside the pixels.
    if (!content.ends_with(End)) throw InputError(path + ": is a damaged PNG: it is cut off");
    return image;
}

std::string png_bytes(const Image& image) {
    Control control;
    control.width = image.width;
    control.height = image.height;
    control.format = PNG_FORMAT_RGB;
    control.flags = PNG_IMAGE_FLAG_FAST; // Writing must not take longer than drawing.
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(control), '\0');
    png_alloc_size_t size = bytes.size();
    if (!png_image_write_to_memory(&control, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr))
        throw InputError("a picture cannot be written: " + std::string(control.message));
    bytes.resize(size);
    return bytes;
}

void write_png(const std::string& path, const Image& image) {
    const std::string bytes = png_bytes(image);
    WholeFile file(path);
    file.write(bytes);
    file.commit();
}

} // namespace ffgpu::tools
