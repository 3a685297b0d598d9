#include "model/work/work_check.h"

#include "model/base/input_error.h"
#include "model/device/enumerators.h"

#include <string>
#include <type_traits>

namespace ffgpu::work {
namespace {

void require(bool condition, const char* what) {
    if (!condition) throw InputError(what);
}

template <class Packed>
void check_enumerators(const Packed& packed, const char* owner) {
    if (const char* const field = find_bad_enumerator(packed))
        throw InputError(std::string(owner) + '.' + field + " holds no value of its kind");
}

void check_surface(const Surface& surface) {
    if (surface.format == Format::None) return;
    require(surface.width <= MaxSurfaceSize && surface.height <= MaxSurfaceSize,
            "a surface exceeds the largest one");
    require(surface.samples == 1 || surface.samples == MaxSamples,
            "a surface has a number of samples that none has");
}

void check_image(const TextureShape& shape) {
    if (shape.kind == TextureKind::None) return;
    require(shape.width <= MaxTextureSize && shape.height <= MaxTextureSize &&
                shape.depth <= MaxTextureSize && shape.levels >= 1 &&
                shape.levels <= MaxTextureLevels,
            "a texture exceeds the largest one");
}

} // namespace

void check_draw(const WorkDraw& draw) {
    if (draw.state) {
        Registers::visit(*draw.state, [](const auto& reg) {
            check_enumerators(reg, std::remove_cvref_t<decltype(reg)>::Name);
        });
        for (const TextureImage& image : draw.state->images)
            check_image(image.shape);
        Targets::for_each(draw.state->targets, check_surface);
    } else {
        require(draw.kind == WorkKind::Copy, "a command without state");
    }
    check_enumerators(draw.image, "draw_image");
    check_enumerators(draw.copy, "copy_rectangle");
    check_surface(draw.copy.source);
    check_surface(draw.copy.destination);
}

} // namespace ffgpu::work
