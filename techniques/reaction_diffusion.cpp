#include "techniques/reaction_diffusion.h"

#include "techniques/random.h"

#include <utility>

namespace ffgpu::techniques {
namespace {

double laplacian(const Field& field, int x, int y) {
    return field.at(x - 1, y) + field.at(x + 1, y) + field.at(x, y - 1) + field.at(x, y + 1) -
           4 * field.at(x, y);
}

} // namespace

Reaction seed_reaction(int size, std::uint64_t seed, int spots, int half) {
    Reaction reaction{Field(size, size, 1), Field(size, size, 0)};
    Random random(seed);
    for (int spot = 0; spot < spots; ++spot) {
        const int centre_x = random.below(size);
        const int centre_y = random.below(size);
        for (int y = centre_y - half; y <= centre_y + half; ++y) {
            for (int x = centre_x - half; x <= centre_x + half; ++x) {
                reaction.u.at(x, y) = 0.5;
                reaction.v.at(x, y) = 0.25;
            }
        }
    }
    return reaction;
}

void advance(Reaction& reaction, const GrayScott& rates, int steps) {
    Reaction next = reaction;
    for (int step = 0; step < steps; ++step) {
        for (int y = 0; y < reaction.u.height; ++y) {
            for (int x = 0; x < reaction.u.width; ++x) {
                const double u = reaction.u.at(x, y), v = reaction.v.at(x, y);
                const double fed = u * v * v;
                next.u.at(x, y) =
                    u + rates.spread_u * laplacian(reaction.u, x, y) - fed + rates.feed * (1 - u);
                next.v.at(x, y) = v + rates.spread_v * laplacian(reaction.v, x, y) + fed -
                                  (rates.feed + rates.kill) * v;
            }
        }
        std::swap(reaction, next);
    }
}

} // namespace ffgpu::techniques
