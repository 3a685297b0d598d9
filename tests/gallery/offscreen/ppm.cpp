#include "tests/gallery/offscreen/ppm.h"

#include "model/base/input_error.h"

#include <fstream>
#include <iterator>

namespace ffgpu::gallery {
namespace {

constexpr std::size_t RowBytes = std::size_t{3} * WindowWidth;
const std::string Head =
    "P6\n" + std::to_string(WindowWidth) + " " + std::to_string(WindowHeight) + "\n255\n";

// Between rows from the bottom and rows from the top.
Picture turned_over(const Picture& picture) {
    Picture result;
    for (std::size_t row = WindowHeight; row-- > 0;) {
        const auto first = picture.begin() + static_cast<std::ptrdiff_t>(row * RowBytes);
        result.insert(result.end(), first, first + RowBytes);
    }
    return result;
}

} // namespace

void write_ppm(const std::string& path, const Picture& picture) {
    const Picture rows = turned_over(picture);
    std::ofstream file(path, std::ios::binary);
    file << Head;
    file.write(reinterpret_cast<const char*>(rows.data()),
               static_cast<std::streamsize>(rows.size()));
    if (!file) throw InputError(path + ": cannot be written");
}

Picture read_ppm(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    if (!all.starts_with(Head) || all.size() != Head.size() + RowBytes * WindowHeight)
        throw InputError(path + ": expected a PPM of the gallery's window");
    return turned_over(Picture(all.begin() + static_cast<std::ptrdiff_t>(Head.size()), all.end()));
}

} // namespace ffgpu::gallery
