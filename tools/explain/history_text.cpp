#include "tools/explain/history_text.h"

#include "tools/explain/fragment_text.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

std::string value_text(const PixelValue& value) {
    std::string text;
    for (unsigned i = 0; i < value.samples; ++i)
        text += fmt::format("{}{}", i == 0 ? "" : " ", color_text(value.color[i]));
    return text;
}

std::string pixel_text(const SurfacePixel& pixel) {
    return fmt::format("window pixel ({}, {}) of the {} surface at {:#010x}{}",
                       pixel.x,
                       pixel.y,
                       format_info(pixel.surface.format).name,
                       pixel.surface.address,
                       pixel.surface.samples > 1 ? ", 4 samples" : "");
}

std::string place_text(const PixelHistory& history, std::size_t number) {
    if (number == 0) return "place 0: ";
    const PixelPlace& place = history.places[number];
    const std::string picture =
        place.pictures > 1 ? fmt::format(" as picture {} of {}", place.picture, place.pictures)
                           : std::string();
    return fmt::format("place {}, copied from{}: ", number, picture);
}

std::string clear_text(const PixelEvent& event) {
    const ClearCommand& clear = event.clear;
    std::string text;
    if (clear.color) text += fmt::format("   color {}\n", color_text(clear.color_value));
    if (clear.depth) text += fmt::format("   depth {}\n", clear.depth_value);
    if (clear.stencil) text += fmt::format("   stencil {}\n", clear.stencil_value);
    if (event.outside_scissor) text += "   scissor: the pixel lies outside, and stays\n";
    return text;
}

std::string fragment_text(const PixelEvent& event) {
    const FragmentNote& fragment = *event.fragment;
    std::string text = geometry_text(fragment);
    for (const TextureNote& texture : fragment.textures)
        text += texture_text(fragment, texture);
    return text + shading_text(fragment) + tests_text(fragment);
}

std::string details(const PixelEvent& event) {
    switch (event.kind) {
    case PixelEvent::Kind::Fragment:
        return fragment_text(event);
    case PixelEvent::Kind::Scissor:
        return "   the triangle covers the pixel, which lies outside the scissor\n";
    case PixelEvent::Kind::Stipple:
        return "   the primitive covers the pixel, where the stipple pattern has a hole\n";
    case PixelEvent::Kind::Clear:
        return clear_text(event);
    case PixelEvent::Kind::StencilImage:
        return event.outside_scissor ? "   scissor: the pixel lies outside, and stays\n" : "";
    case PixelEvent::Kind::Copy:
        if (event.pictures > 1)
            return fmt::format("   the mean of {} pictures, the first of them {}\n",
                               event.pictures,
                               pixel_text(event.source));
        return fmt::format("   from {}\n", pixel_text(event.source));
    case PixelEvent::Kind::Upload:
        return "";
    }
    return "";
}

std::string event_text(const PixelHistory& history, std::size_t number) {
    const PixelEvent& event = history.events[number];
    std::string text =
        fmt::format("\n{}. {}", number + 1, EventNames[static_cast<std::size_t>(event.kind)]);
    if (history.places.size() > 1) text += fmt::format(", place {}", event.place);
    if (!event.call.name.empty())
        text += fmt::format(", call {} {}", event.call.number, event.call.name);
    if (event.is_of_draw())
        text += fmt::format(", draw {}, primitive {}", event.draw, event.primitive);
    if (event.fragment)
        text +=
            fmt::format(", piece {}, sequence {:#x}", event.piece, event.fragment->key.sequence);
    text += '\n' + details(event);
    if (event.depth_after) text += fmt::format("   depth is {}", *event.depth_after);
    if (event.stencil_after) text += fmt::format(", stencil is {}", *event.stencil_after);
    if (event.depth_after) text += '\n';
    return text + fmt::format("   => {}\n", value_text(event.after));
}

} // namespace

std::string history_text(const PixelHistory& history) {
    std::string text = fmt::format("frame {}, pixel ({}, {}) from the upper left: {}\n",
                                   history.frame,
                                   history.x,
                                   history.y,
                                   color_text(history.value));
    for (std::size_t i = 0; i < history.places.size(); ++i)
        text += fmt::format("{}{}; before the frame {}\n",
                            place_text(history, i),
                            pixel_text(history.places[i].color),
                            value_text(history.before[i]));
    if (!history.from_trace) text += "a device capture: the GL calls are not in it\n";
    if (history.cycles != 0)
        text += fmt::format("the frame took {} cycles; cycles below count from its begin\n",
                            history.cycles);
    for (std::size_t i = 0; i < history.events.size(); ++i)
        text += event_text(history, i);
    if (history.events.empty()) text += "\nnothing touched it in this frame\n";
    return text;
}

} // namespace ffgpu::tools
