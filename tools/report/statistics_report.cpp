#include "tools/report/statistics_report.h"

#include "tools/report/summary.h"

#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr unsigned SchemaVersion = 2;

Json object_of(const work::Figures& figures) {
    Json json = Json::object();
    for (const auto& [name, value] : figures)
        json[name] = value;
    return json;
}

void add_to(Json& totals, const Json& frame) {
    for (const auto& [name, value] : frame.items()) {
        if (value.is_object()) {
            if (!totals.contains(name)) totals[name] = Json::object();
            add_to(totals[name], value);
        } else if (value.is_number_unsigned()) {
            totals[name] = totals.value(name, std::uint64_t{0}) + value.get<std::uint64_t>();
        }
    }
}

template <class Field>
Json parameter(const Field& field, const ParameterInfo& info) {
    if constexpr (std::is_enum_v<Field>) {
        return std::string(info.choices[static_cast<std::size_t>(field)]);
    } else {
        return field;
    }
}

// All that decides a result. How the functional GPU draws does not, nor, without timing, does the
// rest.
Json describe(const Configuration& configuration, bool with_timing) {
    Json json = Json::object();
    Configuration::visit(configuration, [&](std::string_view group_name, const auto& group) {
        using Group = std::remove_cvref_t<decltype(group)>;
        if (!with_timing || std::is_same_v<Group, GpuParameters>) return;
        Json fields = Json::object();
        Group::visit(group,
                     [&](std::string_view name, const auto& field, const ParameterInfo& info) {
                         fields[std::string(name)] = parameter(field, info);
                     });
        json[std::string(group_name)] = std::move(fields);
    });
    return json;
}

// As an element of a member of the whole.
std::string indented(const Json& json) {
    std::istringstream lines(json.dump(1));
    std::string text;
    for (std::string line; std::getline(lines, line);)
        text.append(text.empty() ? "  " : "\n  ").append(line);
    return text;
}

double per(std::uint64_t amount, std::uint64_t of) {
    return of == 0 ? 0 : static_cast<double>(amount) / static_cast<double>(of);
}

} // namespace

struct StatisticsReport::Content {
    bool with_timing = false;
    timing::ClockConfig clock;
    Json configuration;
    TextSpool frames; // each as the array in the file holds it, with commas between
    std::size_t frame_count = 0;
    Json totals = Json::object();
};

StatisticsReport::StatisticsReport(const Configuration& configuration, bool with_timing)
    : content_(std::make_unique<Content>()) {
    content_->with_timing = with_timing;
    content_->clock = configuration.timing.clock;
    content_->configuration = describe(configuration, with_timing);
}

StatisticsReport::~StatisticsReport() = default;

void StatisticsReport::add(const work::FrameFigures& frame, const TimedFigures& timed) {
    Json json = Json::object();
    json["frame"] = frame.number;
    json["width"] = frame.width;
    json["height"] = frame.height;
    Json counted = Json::object();
    counted["api_calls"] = frame.api_calls;
    counted["pixels"] = std::uint64_t{frame.width} * frame.height;
    counted["functional"] = object_of(frame.functional);
    if (content_->with_timing) {
        counted["timing"] = Json::object();
        counted["timing"]["total_cycles"] = timed.frame ? timed.frame->cycles : 0;
        counted["timing"].update(object_of(timed.counters));
    }
    add_to(content_->totals, counted);
    json.update(counted);
    json["overdraw"] = per(counted["functional"].value("fragments_written", std::uint64_t{0}),
                           counted["pixels"].get<std::uint64_t>());
    if (content_->with_timing && timed.frame) {
        Json commands = Json::array();
        for (const timing::CommandCycles& command : timed.frame->commands)
            commands.push_back(
                {{"kind", timing::CommandKindNames[static_cast<std::size_t>(command.kind)]},
                 {"draw", command.number},
                 {"cycles", command.cycles},
                 {"bottleneck",
                  timing::ResourceNames[static_cast<std::size_t>(command.bottleneck())]},
                 {"bottleneck_cycles", command.bottleneck_cycles()}});
        json["milliseconds"] = content_->clock.milliseconds(timed.frame->cycles);
        json["commands"] = std::move(commands);
    }
    content_->frames.append((content_->frame_count++ == 0 ? "\n" : ",\n") + indented(json));
}

void StatisticsReport::write(const TextSink& out) const {
    Json json = Json::object();
    json["schema_version"] = SchemaVersion;
    json["configuration"] = content_->configuration;
    json["frame_count"] = content_->frame_count;
    json["totals"] = content_->totals;
    const std::string head = json.dump(1);
    out(std::string_view(head).substr(0, head.size() - 2));
    out(",\n \"frames\": [");
    content_->frames.copy_to(out);
    out(content_->frame_count == 0 ? "]\n}\n" : "\n ]\n}\n");
}

std::string StatisticsReport::summary() const {
    return summarize(content_->totals, content_->frame_count, content_->clock);
}

} // namespace ffgpu::tools
