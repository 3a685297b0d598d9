#include "tools/explain/pixel_history.h"

#include "model/raster/edge.h"

namespace ffgpu::tools {
namespace {

SubPixelPoint at(const WindowVertex& vertex) {
    return {vertex.x, vertex.y};
}

} // namespace

// The triangles that the centre makes with each side, over the whole: twice the areas are integers.
std::vector<double> PrimitiveNote::weights(unsigned x, unsigned y) const {
    if (shape != PrimitiveShape::Triangle) return {};
    constexpr int Pixel = 1 << SubPixelBits;
    const SubPixelPoint centre{static_cast<int>(x) * Pixel + Pixel / 2,
                               static_cast<int>(y) * Pixel + Pixel / 2};
    const SubPixelPoint a = at(vertices[0]), b = at(vertices[1]), c = at(vertices[2]);
    const auto whole = static_cast<double>(double_area(a, b, c));
    if (whole == 0) return {};
    return {static_cast<double>(double_area(centre, b, c)) / whole,
            static_cast<double>(double_area(a, centre, c)) / whole,
            static_cast<double>(double_area(a, b, centre)) / whole};
}

std::vector<double> PrimitiveNote::perspective_weights(unsigned x, unsigned y) const {
    std::vector<double> shares = weights(x, y);
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
        sum += shares[i] *= static_cast<double>(vertices[i].inverse_w);
    for (double& share : shares)
        share /= sum;
    return shares;
}

} // namespace ffgpu::tools
