#include "tools/explain/history_json.h"

#include "tools/explain/fragment_json.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

Json value_json(const PixelValue& value) {
    if (value.samples == 1) return color_json(value.color[0]);
    Json samples = Json::array();
    for (unsigned i = 0; i < value.samples; ++i)
        samples.push_back(color_json(value.color[i]));
    return samples;
}

Json pixel_json(const SurfacePixel& pixel) {
    return {{"surface", fmt::format("{:#010x}", pixel.surface.address)},
            {"format", format_info(pixel.surface.format).name},
            {"samples", pixel.surface.samples},
            {"x", pixel.x},
            {"y", pixel.y}};
}

Json clear_json(const ClearCommand& clear) {
    Json json = Json::object();
    if (clear.color) json["color"] = color_json(clear.color_value);
    if (clear.depth) json["depth"] = clear.depth_value;
    if (clear.stencil) json["stencil"] = clear.stencil_value;
    return json;
}

Json event_json(const PixelEvent& event) {
    Json json{{"event", EventNames[static_cast<std::size_t>(event.kind)]}, {"place", event.place}};
    if (event.call.name.empty())
        json["call"] = nullptr;
    else
        json["call"] = {{"number", event.call.number}, {"name", event.call.name}};
    if (event.is_of_draw()) json["draw"] = event.draw;
    if (event.is_of_draw()) json["primitive"] = event.primitive;
    if (event.kind == PixelEvent::Kind::Clear) json["clear"] = clear_json(event.clear);
    if (event.kind == PixelEvent::Kind::Copy) json["from"] = pixel_json(event.source);
    if (event.pictures > 1) json["pictures"] = event.pictures;
    if (event.outside_scissor) json["outside_scissor"] = true;
    if (event.fragment) add_fragment_json(*event.fragment, json);
    if (event.depth_after) json["depth_after"] = *event.depth_after;
    if (event.stencil_after) json["stencil_after"] = *event.stencil_after;
    json["after"] = value_json(event.after);
    return json;
}

} // namespace

Json history_json(const PixelHistory& history) {
    Json json{{"frame", history.frame}, {"x", history.x}, {"y", history.y}};
    json["value"] = color_json(history.value);
    json["calls"] = history.from_trace;
    if (history.cycles != 0) json["cycles"] = history.cycles;
    json["places"] = Json::array();
    for (std::size_t i = 0; i < history.places.size(); ++i) {
        Json place = pixel_json(history.places[i].color);
        place["before"] = value_json(history.before[i]);
        if (history.places[i].pictures > 1) place["picture"] = history.places[i].picture;
        json["places"].push_back(std::move(place));
    }
    json["events"] = Json::array();
    for (const PixelEvent& event : history.events)
        json["events"].push_back(event_json(event));
    return json;
}

} // namespace ffgpu::tools
