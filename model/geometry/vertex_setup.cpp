#include "model/geometry/vertex_setup.h"

#include "model/packets/rectangle.h"

#include <algorithm>

namespace ffgpu {
namespace {

Mat4 multiply(const Mat4& a, const Mat4& b) {
    Mat4 product;
    for (unsigned column = 0; column < 4; ++column)
        for (unsigned row = 0; row < 4; ++row) {
            double sum = 0;
            for (unsigned k = 0; k < 4; ++k)
                sum += double{a[4 * k + row]} * double{b[4 * column + k]};
            product[4 * column + row] = static_cast<float>(sum);
        }
    return product;
}

bool uses(const TexCoordSetup& setup, TexGenMode mode) {
    return std::find(setup.mode.begin(), setup.mode.end(), mode) != setup.mode.end();
}

// The pixels that fragments can be made for.
Rectangle drawn_pixels(const Registers& registers) {
    const Scissor& scissor = registers.scissor;
    Rectangle drawn{scissor.x, scissor.y, scissor.x + scissor.width, scissor.y + scissor.height};
    Targets::for_each(registers.targets, [&drawn](const Surface& target) {
        if (target.format != Format::None)
            drawn = intersect(drawn, {0, 0, target.width, target.height});
    });
    return drawn;
}

bool viewport_covers(const Viewport& viewport, const Rectangle& pixels) {
    return viewport.x <= static_cast<float>(pixels.x0) &&
           viewport.y <= static_cast<float>(pixels.y0) &&
           viewport.x + viewport.width >= static_cast<float>(pixels.x1) &&
           viewport.y + viewport.height >= static_cast<float>(pixels.y1);
}

void add_texture_units(const Registers& registers, VertexSetup& setup) {
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        if (setup.layout.tex_coord[unit] < 0) continue;
        const TexCoordSetup& tex_coord = registers.tex_coords[unit];
        const bool generates = tex_coord.mode != std::array<TexGenMode, 4>{};
        setup.read[static_cast<unsigned>(ffgpu::tex_coord(unit))] = true;
        if (!generates && !tex_coord.matrix_enable) continue;

        setup.units[setup.unit_count++] = {
            .unit = unit,
            .components = setup.layout.tex_components[unit],
            .generate = generates,
            .registers = &tex_coord,
        };
        const bool sphere = uses(tex_coord, TexGenMode::SphereMap);
        const bool reflection = uses(tex_coord, TexGenMode::ReflectionMap);
        setup.needs_eye |= uses(tex_coord, TexGenMode::EyeLinear);
        setup.needs_view |= sphere || reflection;
        setup.needs_normal |= sphere || reflection || uses(tex_coord, TexGenMode::NormalMap);
    }
}

void add_colors(const Registers& registers, VertexSetup& setup) {
    const bool has_color = setup.layout.color >= 0;
    const bool has_secondary = setup.layout.secondary >= 0;
    auto& read = setup.read;
    if (registers.lighting.enable && (has_color || has_secondary)) {
        setup.lighting =
            make_lighting_setup(registers.lighting, registers.lights, registers.materials);
        setup.needs_two_sides = setup.lighting.two_sided;
        setup.needs_view |= setup.lighting.needs_view;
        setup.needs_normal |= setup.lighting.count > 0;
        read[static_cast<unsigned>(Attribute::Color)] =
            (registers.lighting.color_material_front | registers.lighting.color_material_back) != 0;
    } else {
        read[static_cast<unsigned>(Attribute::Color)] = has_color;
        read[static_cast<unsigned>(Attribute::SecondaryColor)] = has_secondary;
    }
}

} // namespace

WindowSetup make_window_setup(const Registers& registers) {
    const Viewport& viewport = registers.viewport;
    WindowSetup window;
    window.scale = {
        viewport.width / 2, viewport.height / 2, (viewport.far_depth - viewport.near_depth) / 2};
    window.offset = {viewport.x + viewport.width / 2,
                     viewport.y + viewport.height / 2,
                     (viewport.near_depth + viewport.far_depth) / 2};
    window.visible = viewport.width > 0 && viewport.height > 0;
    if (!window.visible) return window;
    if (viewport.clamp_depth) {
        window.low_depth = std::min(viewport.near_depth, viewport.far_depth);
        window.high_depth = std::max(viewport.near_depth, viewport.far_depth);
        window.near_code = clip_code::BeforeNear;
        window.far_code = clip_code::BeyondFar;
    }

    // A pixel less than the guard band: room for the rounding of what is clipped to it.
    constexpr float Guard = GuardBand - 1;
    const bool exact = !viewport_covers(viewport, drawn_pixels(registers));
    const auto limit = [&](unsigned axis, float& low, float& high) {
        const float guard_low = (-Guard - window.offset[axis]) / window.scale[axis];
        const float guard_high = (Guard - window.offset[axis]) / window.scale[axis];
        low = exact ? std::max(-1.0f, guard_low) : guard_low;
        high = exact ? std::min(1.0f, guard_high) : guard_high;
    };
    limit(0, window.low_x, window.high_x);
    limit(1, window.low_y, window.high_y);
    window.visible = window.low_x < window.high_x && window.low_y < window.high_y;
    return window;
}

VertexSetup
make_vertex_setup(const Registers& registers, const InterpolantLayout& layout, VertexNeeds needs) {
    VertexSetup setup;
    setup.registers = &registers;
    setup.layout = layout;
    setup.needs = needs;
    setup.model_view_projection =
        multiply(registers.transform.projection, registers.transform.model_view);
    setup.window = make_window_setup(registers);
    add_colors(registers, setup);
    add_texture_units(registers, setup);

    const bool fog_attribute = registers.fog.source == FogCoordinateSource::Attribute;
    const PrimitiveSetup& primitive = registers.primitive;
    setup.attenuates_points =
        needs.point_size && primitive.point_attenuation != std::array<float, 3>{1, 0, 0};
    setup.needs_view |= (layout.fog >= 0 && !fog_attribute) || setup.attenuates_points;
    setup.needs_eye |= setup.needs_view || registers.clip_planes.enable != 0;

    auto& read = setup.read;
    read[static_cast<unsigned>(Attribute::Position)] = true;
    read[static_cast<unsigned>(Attribute::Normal)] = setup.needs_normal;
    read[static_cast<unsigned>(Attribute::FogCoordinate)] = layout.fog >= 0 && fog_attribute;
    read[static_cast<unsigned>(Attribute::EdgeFlag)] = needs.edge_flag;

    const Mat4& m = registers.transform.model_view;
    const bool w_is_one = registers.vertex_format.elements[0].components <= 3 &&
                          (registers.vertex_format.elements[0].components != 0 ||
                           registers.current.values[0][3] == 1);
    setup.eye_w_is_one = w_is_one && m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
    return setup;
}

InterpolantSources interpolant_sources(const VertexSetup& setup, const VertexBatch& batch) {
    InterpolantSources sources{};
    const InterpolantLayout& layout = setup.layout;
    const auto put = [&](int offset, const auto& planes, unsigned components) {
        for (unsigned i = 0; i < components && offset >= 0; ++i)
            sources[static_cast<unsigned>(offset) + i] = &planes[i];
    };
    put(layout.color, batch.color[0], 4);
    put(layout.secondary, batch.secondary[0], 3);
    if (layout.fog >= 0) sources[static_cast<unsigned>(layout.fog)] = &batch.fog;
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        put(layout.tex_coord[unit],
            batch.in[static_cast<unsigned>(tex_coord(unit))],
            layout.tex_components[unit]);
    for (unsigned i = 0; i < setup.unit_count; ++i)
        put(layout.tex_coord[setup.units[i].unit],
            batch.tex[setup.units[i].unit],
            setup.units[i].components);
    return sources;
}

} // namespace ffgpu
