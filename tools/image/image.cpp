#include "tools/image/image.h"

#include "model/base/input_error.h"

#include <OpenImageIO/imageio.h>

namespace ffgpu::tools {
namespace {

constexpr int CompressionLevel = 1; // zlib's quickest: writing must not take longer than drawing.
constexpr std::size_t MaxPixels = std::size_t{1} << 28;

} // namespace

Image read_image(const std::string& path) {
    const auto file = OIIO::ImageInput::open(path);
    if (!file) {
        const std::string why = OIIO::geterror();
        throw InputError(path + ": is no picture that can be read" +
                         (why.empty() ? "" : ": " + why.substr(0, why.find('\n'))));
    }
    const OIIO::ImageSpec& spec = file->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 ||
        spec.image_pixels() > MaxPixels)
        throw InputError(path + ": its size is not that of a picture");
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    Image image(static_cast<unsigned>(spec.width), static_cast<unsigned>(spec.height));
    std::vector<std::uint8_t> pixels(image.pixels() * channels);
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()))
        throw InputError(path + ": is damaged: " + file->geterror());
    for (std::size_t i = 0; i < image.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.rgb[3 * i + c] = pixels[i * channels + (channels >= 3 ? c : 0)];
    return image;
}

void write_png(const std::string& path, const Image& image) {
    const auto file = OIIO::ImageOutput::create("png");
    OIIO::ImageSpec spec(
        static_cast<int>(image.width), static_cast<int>(image.height), 3, OIIO::TypeDesc::UINT8);
    spec.attribute("png:compressionLevel", CompressionLevel);
    if (!file || !file->open(path, spec) ||
        !file->write_image(OIIO::TypeDesc::UINT8, image.rgb.data()) || !file->close())
        throw InputError(path + ": cannot be written" + (file ? ": " + file->geterror() : ""));
}

} // namespace ffgpu::tools
