#include "driver/objects/texture_object.h"

#include "driver/objects/completeness.h"

namespace ffgpu::gl {

TextureObject::TextureObject(GLuint name, TextureTarget target)
    : name_(name)
    , target_(target)
    , levels_(target == TextureTarget::Cube ? 6 : 1) {
    if (target == TextureTarget::Rectangle) { // ARB_texture_rectangle: no mip maps, no repeat
        parameters.wrap_s = parameters.wrap_t = parameters.wrap_r = GL_CLAMP_TO_EDGE;
        parameters.min_filter = GL_LINEAR;
    }
}

const TextureChain& TextureObject::chain() const {
    if (!chain_known_) {
        chain_ = find_chain(*this);
        chain_known_ = true;
    }
    return chain_;
}

TextureState::TextureState() {
    for (std::size_t i = 0; i < TextureTargets; ++i) {
        defaults[i] = std::make_shared<TextureObject>(0, static_cast<TextureTarget>(i));
        proxies[i] = std::make_shared<TextureObject>(0, static_cast<TextureTarget>(i));
    }
    for (TextureUnit& unit : units)
        unit.bound = defaults;
}

} // namespace ffgpu::gl
