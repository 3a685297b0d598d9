// Texture synthesis by noise: a formula for each texel, no picture. Above: a Fourier-like sum of
// waves whose frequencies lie in a ring; Perlin's gradient noise. Below: turbulence, the sum of the
// sizes of five octaves; stripes in space, shaken by turbulence: marble.

#include "techniques/noise.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <functional>

namespace ffgpu::gallery {
namespace {

using namespace techniques;
using Formula = std::function<double(const glm::dvec3&)>;

// A texel for each pixel of a panel; 24 pixels are a unit of length.
Texels evaluate(const Formula& formula) {
    Field field(256, 128);
    for (int y = 0; y < field.height; ++y) {
        for (int x = 0; x < field.width; ++x)
            field.at(x, y) = formula({(x + 0.5) / 24, (y + 0.5) / 24, 0.37});
    }
    return to_texels(field);
}

} // namespace

void noise_textures(const Scene& scene) {
    clear(0, 0, 0);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    const std::vector<Wave> waves = annulus_waves(1, 24, 3, 6);
    const GradientNoise noise(2);
    const int octaves = scene.broken ? 3 : 5;
    const Stripes marble{{0.8, 0.6, 0}, 1.6, 5, octaves};
    const Formula formulas[] = {
        [&](const glm::dvec3& p) { return 0.5 + 1.5 * fourier(waves, glm::dvec2(p)); },
        [&](const glm::dvec3& p) { return 0.5 + 0.9 * noise(p); },
        [&](const glm::dvec3& p) { return 1.3 * turbulence(noise, 0.7 * p, octaves); },
        [&](const glm::dvec3& p) { return stripe(marble, noise, p); },
    };
    for (int i = 0; i < 4; ++i) {
        texture_2d(evaluate(formulas[i]), GL_NEAREST);
        enter_in_pixels(panel(scene, i, 2, 2));
        draw_rectangle(0, 0, 256, 128); // Beyond the panel it is cut off.
    }
}

} // namespace ffgpu::gallery
