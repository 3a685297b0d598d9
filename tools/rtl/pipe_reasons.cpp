#include "tools/rtl/pipe_reasons.h"

namespace ffgpu::tools {
namespace {

std::string reason_against(const TextureUnit& unit) {
    if (!unit.valid) return "textures without an image";
    if (unit.filter != TextureFilter::Standard) return "wide filters";
    if (unit.kind == TextureKind::Cube) return "cube maps";
    if (unit.compares()) return "depth comparisons";
    return {};
}

bool overlap(const TextureImage& image, const Surface& surface) {
    return surface.format != Format::None && image.address < surface.address + surface.bytes() &&
           surface.address < image.address + texture_bytes(image.shape);
}

std::string reason_against_textures(const DrawContext& context) {
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (!context.pixels->samples(unit)) continue;
        std::string reason = reason_against(context.pixels->textures[unit]);
        if (!reason.empty()) return reason;
        const TextureImage& image = context.regs().images[unit];
        if (image.address % 64 != 0) return "images that do not begin at a line";
        bool own = false;
        Targets::for_each(context.regs().targets,
                          [&](const Surface& surface) { own = own || overlap(image, surface); });
        if (own) return "images that are drawn on";
    }
    return {};
}

// A quad's row of two pixels lies in a word.
bool has_aligned_rows(const Surface& surface) {
    const unsigned pair = 2u * format_info(surface.format).block_bytes;
    return surface.format == Format::None ||
           (surface.address % pair == 0 && surface.stride % pair == 0);
}

std::string reason_against_targets(const FragmentPipe& pipe) {
    unsigned colors = 0;
    bool srgb = false;
    bool aligned = has_aligned_rows(pipe.depth_target);
    for (const ColorTarget& target : pipe.color_targets) {
        colors += target.surface.format != Format::None;
        srgb = srgb || target.srgb;
        aligned = aligned && has_aligned_rows(target.surface);
    }
    if (srgb) return "sRGB targets";
    return colors > 1 ? "several colour targets" : aligned ? "" : "targets with odd rows";
}

std::string reason_against(const SetupRecord& record) {
    if (record.stipple != StippleKind::None) return "stipples";
    return record.coverage == CoverageKind::Centre ? "" : "smooth primitives";
}

} // namespace

std::string reason_against_pipe(const PipeRecords& records) {
    const DrawContext& context = records.context();
    if (context.state.samples > 1) return "multisampling";
    std::string reason = reason_against_targets(context.pixels->pipe);
    if (reason.empty()) reason = reason_against_textures(context);
    records.for_each([&](const SetupRecord& record) {
        if (reason.empty()) reason = reason_against(record);
    });
    return reason;
}

} // namespace ffgpu::tools
