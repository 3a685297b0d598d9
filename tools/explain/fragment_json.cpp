#include "tools/explain/fragment_json.h"

#include "model/memory/pixel_format.h"
#include "tools/explain/history_facts.h"
#include "tools/explain/names.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

Json vertex_json(const WindowVertex& vertex, const std::vector<std::string>& attributes) {
    constexpr double Pixel = 1 << SubPixelBits;
    Json json{{"x", vertex.x / Pixel},
              {"y", vertex.y / Pixel},
              {"depth", vertex.depth},
              {"inverse_w", vertex.inverse_w}};
    for (std::size_t i = 0; i < attributes.size(); ++i)
        json["attributes"][attributes[i]] = vertex.attributes[i];
    return json;
}

void add_primitive(const FragmentNote& fragment, Json& json) {
    if (!fragment.primitive) return;
    const PrimitiveNote& primitive = *fragment.primitive;
    const auto names = attribute_names(fragment.state->layout);
    json["shape"] = name_of(primitive.shape);
    json["front_facing"] = primitive.front_facing;
    json["vertices"] = Json::array();
    for (const WindowVertex& vertex : primitive.vertices)
        json["vertices"].push_back(vertex_json(vertex, names));
    json["edges"] = fragment.edges;
    json["weights"] = primitive.weights(fragment.x, fragment.y);
    json["perspective_weights"] = primitive.perspective_weights(fragment.x, fragment.y);
}

void add_interpolated(const FragmentNote& fragment, Json& json) {
    if (fragment.depth) json["depth"] = *fragment.depth;
    if (!fragment.sample_depths.empty()) json["sample_depths"] = fragment.sample_depths;
    if (fragment.inverse_w)
        json["perspective"] = {{"inverse_w", *fragment.inverse_w}, {"w", fragment.w}};
    if (!fragment.has_colors) return;
    const InterpolantLayout& layout = fragment.state->layout;
    if (layout.color >= 0)
        json["primary"] = {{"over_w", fragment.primary_over_w}, {"color", fragment.primary}};
    if (layout.secondary >= 0)
        json["secondary"] = {{"over_w", fragment.secondary_over_w}, {"color", fragment.secondary}};
    if (layout.fog >= 0)
        json["fog_coordinate"] = {{"over_w", fragment.fog_over_w},
                                  {"value", fragment.fog_coordinate}};
}

Json texel_json(const FragmentNote& fragment,
                unsigned unit,
                unsigned level,
                const probed::Texel& texel) {
    Json json = Json::object();
    if (texel.bytes == 0) {
        json["border"] = true;
    } else {
        json = {{"level", level}, {"x", texel.x}, {"y", texel.y}, {"layer", texel.layer}};
        std::string bytes;
        for (unsigned i = 0; i < texel.bytes; ++i)
            bytes += fmt::format("{:02x}", std::to_integer<unsigned>(texel.stored[i]));
        json["stored"] = bytes;
    }
    json["color"] = texel.color;
    const TexelLookup* const lookup = lookup_of(fragment, unit, level, texel);
    if (texel.bytes == 0 || !lookup || !lookup->cycle) return json;
    json["cache"] = lookup->missed ? "miss" : "hit";
    json["cycle"] = *lookup->cycle;
    return json;
}

Json filter_json(const FragmentNote& fragment, unsigned unit, const probed::LevelFilter& filter) {
    Json json{{"level", filter.access.level}};
    if (filter.along_x_count > 0) json["weights_256"] = filter.weight;
    if (filter.texel_weights) json["texel_weights"] = *filter.texel_weights;
    json["texels"] = Json::array();
    for (unsigned i = 0; i < filter.texel_count; ++i)
        json["texels"].push_back(texel_json(fragment, unit, filter.access.level, filter.texels[i]));
    const unsigned pairs = filter.texel_count / 2;
    if (filter.along_x_count == 0) return json;
    if (filter.texel_count > 1) {
        json["along_x"] =
            std::vector<Rgba>(filter.along_x.begin(), filter.along_x.begin() + std::max(pairs, 1u));
        json["along_y"] = std::vector<Rgba>(filter.along_y.begin(),
                                            filter.along_y.begin() + std::max(pairs / 2, 1u));
    }
    json["color"] = filter.color;
    return json;
}

Json half_json(const FragmentNote& fragment,
               const EnvironmentNote& environment,
               const CombineHalf& half) {
    Json json{{"operation", name_of(half.op)}, {"scale", 1u << half.scale_shift}};
    json["arguments"] = Json::array();
    for (const ArgumentFact& fact : arguments_of(fragment, environment, half))
        json["arguments"].push_back(
            {{"source", fact.source}, {"operand", fact.operand}, {"value", fact.value}});
    return json;
}

Json environment_json(const FragmentNote& fragment, const EnvironmentNote& environment) {
    const Combiner& combiner = fragment.registers().combiners[environment.unit];
    return {{"unit", environment.unit},
            {"previous", environment.previous},
            {"rgb", half_json(fragment, environment, combiner.rgb)},
            {"alpha", half_json(fragment, environment, combiner.alpha)},
            {"result", environment.result}};
}

Json change_json(const ColorChange& change) {
    return {{"before", change.before}, {"after", change.after}};
}

void add_shading(const FragmentNote& fragment, Json& json) {
    for (const TextureNote& texture : fragment.textures)
        json["textures"].push_back(texture_json(fragment, texture));
    for (const EnvironmentNote& environment : fragment.environments)
        json["environments"].push_back(environment_json(fragment, environment));
    if (fragment.color_sum) json["color_sum"] = change_json(*fragment.color_sum);
    if (fragment.fog) {
        json["fog"] = change_json(*fragment.fog);
        json["fog"]["factor"] = fragment.fog_factor;
        json["fog"]["color"] = color_json(fragment.registers().fog.color);
    }
    if (!fragment.antialias) return;
    json["coverage"] = change_json(*fragment.antialias);
    json["coverage"]["factor"] = fragment.coverage;
}

Json visit_json(const FragmentNote& fragment, const DepthVisit& visit) {
    const Registers& registers = fragment.registers();
    Json json{{"sample", visit.sample}, {"early", visit.early}};
    if (registers.stencil.enable) {
        const StencilFace& face = stencil_face(fragment);
        json["stencil"] = {{"function", name_of(face.compare)},
                           {"reference", face.reference},
                           {"mask", face.compare_mask},
                           {"stored", visit.stored_stencil},
                           {"passed", visit.passed_stencil},
                           {"becomes", visit.new_stencil}};
    }
    if (registers.depth.test_enable)
        json["depth"] = {{"function", name_of(registers.depth.compare)},
                         {"value", visit.depth},
                         {"stored", visit.stored_depth},
                         {"passed", visit.passed_depth},
                         {"becomes", visit.new_depth}};
    return json;
}

void add_tests(const FragmentNote& fragment, Json& json) {
    const FragmentControl& control = fragment.registers().fragment;
    if (fragment.sample_mask)
        json["sample_mask"] = {{"before", (*fragment.sample_mask)[0]},
                               {"after", (*fragment.sample_mask)[1]}};
    if (fragment.alpha_passed)
        json["alpha_test"] = {{"function", name_of(control.alpha_compare)},
                              {"alpha", fragment.alpha},
                              {"reference", control.alpha_reference},
                              {"passed", *fragment.alpha_passed}};
    for (const DepthVisit& visit : fragment.visits)
        json["stencil_depth"].push_back(visit_json(fragment, visit));
}

void add_writes(const FragmentNote& fragment, Json& json) {
    const Blend& blend = fragment.registers().blend;
    for (const WriteNote& write : fragment.writes) {
        Json one{{"target", write.target}, {"sample", write.sample}, {"source", write.source}};
        one["destination"] = color_json(write.destination);
        if (blend.logic_op_enable) one["logic_op"] = name_of(blend.logic_op);
        if (blend.enable && !blend.logic_op_enable) {
            one["rgb"] = blend_formula(blend.rgb_equation, blend.rgb_source, blend.rgb_destination);
            one["alpha"] =
                blend_formula(blend.alpha_equation, blend.alpha_source, blend.alpha_destination);
        }
        one["blended"] = color_json(write.blended);
        one["write_mask"] = channels(blend.write_mask);
        one["stored"] = color_json(write.stored);
        json["writes"].push_back(std::move(one));
    }
}

} // namespace

Json color_json(std::uint32_t rgba8) {
    return unpack_rgba8(rgba8);
}

Json texture_json(const FragmentNote& fragment, const TextureNote& texture) {
    Json json{{"unit", texture.unit}, {"coordinates", texture.coordinates}};
    for (unsigned i = 0; i < texture.carried; ++i)
        json["over_w"].push_back(texture.over_w[i]);
    if (texture.quad) {
        const probed::QuadLevels& quad = *texture.quad;
        json["derivatives"] = {{"x", quad.step_x}, {"y", quad.step_y}};
        json["footprint"] = {quad.footprint_x, quad.footprint_y};
        json["lambda"] = quad.lambda / 256.0;
        json["level"] = quad.level;
        json["next_level"] = quad.next_level;
        json["next_weight_256"] = quad.weight;
        json["linear"] = quad.linear;
    }
    json["filter"] = name_of(fragment.registers().samplers[texture.unit].filter);
    for (const ProbeNote& probe : texture.probes) {
        Json one{{"coordinates", probe.probe.coordinates},
                 {"face", probe.probe.face},
                 {"weight", probe.probe.weight},
                 {"next_weight_256", probe.probe.next_level}};
        for (const probed::LevelFilter& filter : probe.levels)
            one["levels"].push_back(filter_json(fragment, texture.unit, filter));
        one["color"] = probe.probe.color;
        json["probes"].push_back(std::move(one));
    }
    json["color"] = texture.color;
    return json;
}

void add_fragment_json(const FragmentNote& fragment, Json& json) {
    json["piece"] = fragment.piece;
    json["sequence"] = fragment.key.sequence;
    json["window"] = {fragment.x, fragment.y};
    if (fragment.image) json["image"] = true;
    if (fragment.state->samples > 1) json["samples_covered"] = fragment.samples_covered;
    add_primitive(fragment, json);
    add_interpolated(fragment, json);
    add_shading(fragment, json);
    add_tests(fragment, json);
    add_writes(fragment, json);
    json["end"] = FragmentEndNames[static_cast<std::size_t>(fragment.end)];
    for (const TargetLookup& lookup : fragment.timing.targets)
        json[lookup.cache == TargetLookup::Cache::Depth ? "depth_cache" : "color_cache"].push_back(
            {{"line", lookup.line},
             {"cache", lookup.missed ? "miss" : "hit"},
             {"cycle", lookup.cycle}});
    if (fragment.timing.retired) json["retired"] = *fragment.timing.retired;
}

} // namespace ffgpu::tools
