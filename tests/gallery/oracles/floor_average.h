// The grazing floor in real numbers, and what a pixel of it ought to show: the mean of its area.

#pragma once

#include "tests/gallery/oracles/space.h"

namespace ffgpu::gallery {

// The picture's coordinates there; nothing beside the floor.
std::optional<glm::dvec2> grazing_floor(const Eye& eye, const glm::dvec2& unit);
Eye grazing_eye(double aspect);

// The mean of samples x samples points of the pixel, each the nearest texel or the background.
Color area_average(const Image& image, const Eye& eye, const Place& place, int samples);

} // namespace ffgpu::gallery
