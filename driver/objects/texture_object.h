// TextureObject: the images and parameters of one texture (GL 1.5, 3.8).
//
// Texels are kept once, in the device's format. An image that fits into the chain of levels that
// the sampler reads lives in device memory, laid out by model/device/layout/texture_layout.h from
// the base level on; an image that does not (yet) is kept by the host, or, once it is drawn to, in
// device memory of its own. Residency (driver/texture/residency.h) moves them; nothing else needs
// to know where they are.

#pragma once

#include "driver/ffgpu_texture_filter.h"
#include "driver/gl_types.h"
#include "driver/objects/device_block.h"
#include "driver/state/texture_state.h"
#include "driver/texel/internal_format.h"
#include "model/device/layout/limits.h"
#include "model/device/layout/texture_layout.h"
#include "model/device/registers/texture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ffgpu::gl {

// One level of one face. Sizes are GL's: they include the border.
struct TextureLevel {
    GLenum internal_format = 1; // as the application asked
    InternalFormat format;      // base None: not defined
    GLsizei width = 0, height = 0, depth = 0;
    GLint border = 0;

    bool resident = false;              // in the object's block, else
    std::shared_ptr<DeviceBlock> block; // in one of its own: drawn to, but not in the chain; else
    std::vector<std::byte> texels;      // here. Layers, rows of blocks, tightly packed

    bool defined() const { return format.base != BaseFormat::None && width > 0; }
};

struct TextureParameters {
    GLenum wrap_s = GL_REPEAT, wrap_t = GL_REPEAT, wrap_r = GL_REPEAT;
    GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR;
    GLenum mag_filter = GL_LINEAR;
    std::array<float, 4> border_color{0, 0, 0, 0};
    float priority = 1;
    float min_lod = -1000, max_lod = 1000;
    GLint base_level = 0, max_level = 1000;
    float lod_bias = 0;
    float max_anisotropy = 1;
    bool generate_mipmap = false;
    GLenum depth_mode = GL_LUMINANCE;
    GLenum compare_mode = GL_NONE;
    GLenum compare_func = GL_LEQUAL;
    GLenum filter = GL_STANDARD_FILTER_FFGPU;

    bool operator==(const TextureParameters&) const = default;
};

// The levels that fit together around the base level: they share one block of device memory.
struct TextureChain {
    TextureShape shape;    // of level `root`; kind None: there is no base image
    unsigned root = 0;     // GL's number of the first level in the chain
    unsigned base = 0;     // the first level that the sampler reads
    unsigned last = 0;     // the last one
    bool complete = false; // GL 1.5, 3.8.10: the texture can be used with its filters
    BaseFormat base_format = BaseFormat::None;
    bool srgb = false;
};

// What a filter reads in place of the texture's images (driver/texture/filter_table.h).
struct FilterTable {
    TextureFilter filter = TextureFilter::Standard; // Standard: there is none
    DeviceBlock block;
    TextureShape shape;
    std::uint16_t source_width = 0, source_height = 0;
    bool current = false; // made from the texels as they are
};

class TextureObject {
public:
    TextureObject(GLuint name, TextureTarget target);

    GLuint name() const { return name_; }
    TextureTarget target() const { return target_; }
    unsigned faces() const { return target_ == TextureTarget::Cube ? 6 : 1; }

    TextureParameters parameters;
    GLenum forced_filter = 0; // in place of parameters.filter; 0: it stays. Not GL's to know.
    bool deleted = false;     // glDeleteTextures took its name; only references keep it.

    // level < MaxTextureLevels.
    TextureLevel& level(unsigned face, unsigned level) { return levels_[face][level]; }
    const TextureLevel& level(unsigned face, unsigned level) const { return levels_[face][level]; }

    // To be called after a change of levels' definitions or of parameters.
    void changed() { chain_known_ = resident_is_current_ = filter_table.current = false; }
    const TextureChain& chain() const; // computed when something changed

    // Where the resident levels are: `shape` has those from `root` on.
    struct Resident {
        DeviceBlock block;
        TextureShape shape;
        unsigned root = 0;
    };
    Resident resident;
    bool resident_is_current() const { return resident_is_current_; } // all of the chain is there
    void note_resident() { resident_is_current_ = true; }

    FilterTable filter_table;
    // The device may write to its images at any time: a table is never sure to be current.
    bool is_drawn_to() const { return drawn_to_; }
    void note_drawing() { drawn_to_ = true; }

private:
    GLuint name_;
    TextureTarget target_;
    bool drawn_to_ = false;
    std::vector<std::array<TextureLevel, MaxTextureLevels>> levels_; // by face
    mutable TextureChain chain_;
    mutable bool chain_known_ = false;
    bool resident_is_current_ = false;
};

} // namespace ffgpu::gl
