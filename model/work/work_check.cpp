#include "model/work/work_check.h"

#include "model/base/input_error.h"
#include "model/device/validate.h"

namespace ffgpu::work {
namespace {

constexpr std::uint64_t AnyMemory = std::uint64_t{1} << 32; // The file does not tell its size.

} // namespace

void check_draw(const WorkDraw& draw) {
    if (draw.kind == WorkKind::Copy) return validate(draw.copy, AnyMemory);
    if (!draw.state) throw InputError("a command without state");
    validate(*draw.state, AnyMemory);
    if (draw.kind == WorkKind::Image) validate(draw.image, AnyMemory);
}

} // namespace ffgpu::work
