#include "tools/image/compare_images.h"

#include "model/base/check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ffgpu::tools {
namespace {

constexpr unsigned PictureGain = 8;

unsigned distance(std::uint8_t a, std::uint8_t b) {
    return static_cast<unsigned>(std::abs(a - b));
}

} // namespace

Difference compare_images(const Image& a, const Image& b) {
    check(a.width == b.width && a.height == b.height, "pictures to compare differ in size");
    Difference result;
    std::uint64_t squares = 0;
    std::size_t close = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        unsigned worst = 0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const unsigned apart = distance(a.rgb[c], b.rgb[c]);
            squares += apart * apart;
            worst = std::max(worst, apart);
        }
        close += worst <= 16;
        if (worst > result.worst_difference) {
            result.worst_difference = worst;
            result.worst_x = static_cast<unsigned>(i % a.width);
            result.worst_y = static_cast<unsigned>(i / a.width);
        }
    }
    if (a.pixels() == 0) return result;
    const auto pixels = static_cast<double>(a.pixels());
    result.rmse = std::sqrt(static_cast<double>(squares) / (3 * pixels));
    result.psnr =
        squares == 0 ? std::numeric_limits<double>::infinity() : 20 * std::log10(255 / result.rmse);
    result.within_16 = static_cast<double>(close) / pixels;
    return result;
}

Image difference_picture(const Image& a, const Image& b) {
    Image picture(a.width, a.height);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        picture.rgb[i] =
            static_cast<std::uint8_t>(std::min(255u, PictureGain * distance(a.rgb[i], b.rgb[i])));
    return picture;
}

} // namespace ffgpu::tools
