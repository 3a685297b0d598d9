#include "driver/device_context/supersampling.h"

#include "driver/device_context/device_context.h"

namespace ffgpu::gl {
namespace {

// `index`, below the power of two `count`, with its bits in the other order.
unsigned reversed(unsigned index, unsigned count) {
    unsigned result = 0;
    for (unsigned bit = 1; bit < count; bit *= 2, index /= 2)
        result = 2 * result + index % 2;
    return result;
}

void select_picture(const Targets& of_first, unsigned picture, Targets& targets) {
    const auto place = [picture](const Surface& from, Surface& to) {
        if (from.format != Format::None) to = from.plane(picture);
    };
    for (unsigned i = 0; i < ColorTargets; ++i)
        place(of_first.color[i], targets.color[i]);
    place(of_first.depth, targets.depth);
}

void update(RegisterFile& registers) {
    registers.update<&Registers::targets>();
    registers.update<&Registers::viewport>();
    registers.update<&Registers::fragment>();
}

} // namespace

std::array<float, 2> sample_position(unsigned picture, unsigned pictures) {
    const auto part = [pictures](unsigned step) {
        return (static_cast<float>(step) + 0.5f) / static_cast<float>(pictures);
    };
    return {part(picture), part(reversed(picture, pictures))};
}

void submit_to_pictures(DeviceContext& context, const CommandStream& commands) {
    RegisterFile& registers = context.registers;
    Registers& wanted = registers.wanted;
    const Targets targets = wanted.targets;
    const Viewport viewport = wanted.viewport;
    const bool counts = wanted.fragment.count_samples;
    const unsigned pictures = context.draw_target().supersampling;
    for (unsigned i = 0; i < pictures; ++i) {
        const auto [x, y] = sample_position(i, pictures);
        select_picture(targets, i, wanted.targets);
        wanted.viewport.x = viewport.x + (0.5f - x);
        wanted.viewport.y = viewport.y + (0.5f - y);
        wanted.fragment.count_samples = counts && i == 0;
        update(registers);
        context.submit(commands);
    }
    wanted.targets = targets;
    wanted.viewport = viewport;
    wanted.fragment.count_samples = counts;
    update(registers);
}

} // namespace ffgpu::gl
