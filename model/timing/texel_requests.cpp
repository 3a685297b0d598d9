#include "model/timing/texel_requests.h"

namespace ffgpu::timing {

void TexelRequests::take(const QuadToken& token) {
    const PreparedQuad& quad = token.quad();
    for (const work::TexturePart& texture : token.part->work.textures_of(quad))
        if (texture.filter_steps > 0)
            requests_.push_back(std::uint32_t{texture.filter_steps} * live_lanes(quad));
}

void TexelRequests::advance() {
    if (!moves()) return;
    if (samples_left_ > 0) {
        --samples_left_;
        ++samples_;
    } else {
        samples_left_ = requests_.front();
        requests_.pop_front();
    }
}

} // namespace ffgpu::timing
