// ffgpu_pictures.so: pictures of any format, read by OpenImageIO.

#include "tools/image/picture_formats.h"

#include <OpenImageIO/imageio.h>

namespace ffgpu::tools {
namespace {

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

bool read(const std::string& path, Image& image, std::string& why) {
    const auto file = OIIO::ImageInput::open(path);
    if (!file) {
        why = "is no picture that can be read: " + first_line(OIIO::geterror());
        return false;
    }
    const OIIO::ImageSpec& spec = file->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 ||
        spec.image_pixels() > MaxImagePixels) {
        why = "its size is not that of a picture";
        return false;
    }
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    image = Image(static_cast<unsigned>(spec.width), static_cast<unsigned>(spec.height));
    std::vector<std::uint8_t> pixels(image.pixels() * channels);
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data())) {
        why = "is damaged: " + first_line(file->geterror());
        return false;
    }
    for (std::size_t i = 0; i < image.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.rgb[3 * i + c] = pixels[i * channels + (channels >= 3 ? c : 0)];
    return true;
}

} // namespace
} // namespace ffgpu::tools

extern "C" __attribute__((visibility("default"))) bool
ffgpu_read_picture(const std::string& path, ffgpu::tools::Image& image, std::string& why) {
    try {
        return ffgpu::tools::read(path, image, why);
    } catch (const std::exception& error) {
        why = error.what();
        return false;
    }
}
