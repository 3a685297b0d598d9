#include "tools/report_page/page_pictures.h"

#include "model/base/input_error.h"
#include "tools/image/png_file.h"
#include "tools/page/data_url.h"
#include "tools/page/json_text.h"
#include "tools/report_page/listed_pictures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

constexpr unsigned MostShrunk = 16;

struct Picture {
    std::size_t frame; // place
    std::string map, path;
    std::size_t bytes;
};

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw InputError(path + ": cannot be read");
    return std::move(text).str();
}

// frame_0003.png, heat_cycles_0003.png, view_depth_0003.png; the first of them first, then by name.
std::vector<Picture> pictures_in(const std::string& folder, const RunFigures& figures) {
    std::map<std::uint64_t, std::size_t> places;
    for (std::size_t i = 0; i < figures.frames.size(); ++i)
        places[figures.frames[i].number] = i;
    const std::regex name("(frame|heat_[a-z_]+|view_[a-z_]+)_([0-9]{4,18})\\.png");
    std::vector<Picture> pictures;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        std::smatch match;
        const std::string file = entry.path().filename().string();
        if (!std::regex_match(file, match, name)) continue;
        const auto place = places.find(std::stoull(match[2]));
        if (place == places.end()) continue;
        pictures.push_back({place->second,
                            match[1],
                            entry.path().string(),
                            static_cast<std::size_t>(entry.file_size())});
    }
    std::sort(pictures.begin(), pictures.end(), [](const Picture& a, const Picture& b) {
        return std::pair(a.frame, a.map) < std::pair(b.frame, b.map);
    });
    return pictures;
}

bool fits(const Image& image, const RunFrame& frame, const std::string& map) {
    const bool has_legend = map.starts_with("heat_");
    return image.width == frame.width &&
           (has_legend ? image.height >= frame.height : image.height == frame.height);
}

Image rows_of(const Image& image, unsigned first, unsigned count) {
    Image part(image.width, count);
    const auto begin = image.rgb.begin() + std::ptrdiff_t{3} * image.width * first;
    std::copy(begin, begin + static_cast<std::ptrdiff_t>(part.rgb.size()), part.rgb.begin());
    return part;
}

// The mean of squares of `factor` pixels; what is left over at the right and below is cut off.
Image shrunk(const Image& image, unsigned factor) {
    Image result(std::max(1u, image.width / factor), std::max(1u, image.height / factor));
    const unsigned columns = std::min(factor, image.width), rows = std::min(factor, image.height);
    for (unsigned y = 0; y < result.height; ++y)
        for (unsigned x = 0; x < result.width; ++x)
            for (unsigned c = 0; c < 3; ++c) {
                unsigned sum = 0;
                for (unsigned j = 0; j < rows; ++j)
                    for (unsigned i = 0; i < columns; ++i)
                        sum += image.rgb[3 * (std::size_t{image.width} * (y * factor + j) +
                                              x * factor + i) +
                                         c];
                result.rgb[3 * (std::size_t{result.width} * y + x) + c] =
                    static_cast<std::uint8_t>((sum + columns * rows / 2) / (columns * rows));
            }
    return result;
}

// `image` is what `content`, a file, holds.
nlohmann::ordered_json
entry_of(const std::string& content, const Image& image, unsigned height, unsigned factor) {
    if (factor == 1) return {{"body", data_url("image/png", content)}};
    const auto url = [](const Image& part) { return data_url("image/png", png_bytes(part)); };
    nlohmann::ordered_json entry{{"body", url(shrunk(rows_of(image, 0, height), factor))}};
    if (image.height > height) entry["legend"] = url(rows_of(image, height, image.height - height));
    return entry;
}

// The smallest factor by which all are likely to fit.
unsigned factor_for(const std::vector<Picture>& pictures, std::size_t most_bytes) {
    std::size_t bytes = 0;
    for (const Picture& picture : pictures)
        bytes += data_url_size(picture.bytes);
    unsigned factor = 1;
    // What is shrunk compresses worse, pixel for pixel.
    while (factor < MostShrunk && bytes * (factor == 1 ? 1 : 2) / factor / factor > most_bytes)
        factor *= 2;
    return factor;
}

} // namespace

PagePictures
pictures_of(const std::string& folder, const RunFigures& figures, std::size_t most_bytes) {
    PagePictures result;
    const auto leave_to_others = [&](const Picture& picture) {
        ++result.of_others;
        result.maps_of_others.insert(picture.map);
    };
    std::vector<Picture> pictures = pictures_in(folder, figures);
    const ListedPictures listed(folder, figures);
    std::erase_if(pictures, [&](const Picture& picture) {
        const bool is_listed = listed.holds(picture.frame, picture.map);
        if (!is_listed) leave_to_others(picture);
        return !is_listed;
    });
    result.shrunk = factor_for(pictures, most_bytes);
    result.frames = std::vector<nlohmann::ordered_json>(figures.frames.size(),
                                                        nlohmann::ordered_json::object());
    std::set<std::string> maps;
    for (const Picture& picture : pictures) {
        const RunFrame& frame = figures.frames[picture.frame];
        // Also where it goes into the page as it is: a browser shows a damaged one as far as it is
        // whole, and says nothing.
        const std::string content = content_of(picture.path);
        const Image image = read_whole_png(content, picture.path);
        if (!fits(image, frame, picture.map)) {
            leave_to_others(picture);
            continue;
        }
        nlohmann::ordered_json entry =
            entry_of(content, image, static_cast<unsigned>(frame.height), result.shrunk);
        const std::size_t bytes = json_text(entry).size() + picture.map.size();
        if (bytes > most_bytes) {
            ++result.left_out;
            continue;
        }
        most_bytes -= bytes;
        result.frames[picture.frame][picture.map] = std::move(entry);
        maps.insert(picture.map);
    }
    result.maps.assign(maps.begin(), maps.end());
    return result;
}

} // namespace ffgpu::tools
