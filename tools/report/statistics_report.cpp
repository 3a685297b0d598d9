#include "tools/report/statistics_report.h"

#include "tools/report/summary.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr unsigned SchemaVersion = 2;

// An object is a list: each look for a name goes through it. Hundreds of names that are there once,
// and in the same order in every frame, are put at the end, and looked for at their places.
using Members = Json::object_t;

Json object_of(const work::Figures& figures) {
    Json json = Json::object();
    auto& members = json.get_ref<Members&>();
    members.reserve(figures.size());
    for (const auto& [name, value] : figures)
        members.push_back({name, value});
    return json;
}

Json& member_at(Json& object, std::size_t place, const std::string& name) {
    auto& members = object.get_ref<Members&>();
    if (place >= members.size()) return object[name];
    auto& member = *std::next(members.begin(), static_cast<std::ptrdiff_t>(place));
    return member.first == name ? member.second : object[name];
}

void add_to_counts(Json& totals, const Json& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (i == totals.size()) totals.push_back(0);
        totals[i] = totals[i].get<std::uint64_t>() + counts[i].get<std::uint64_t>();
    }
}

void add_to(Json& totals, const Json& frame) {
    std::size_t place = 0;
    for (const auto& [name, value] : frame.get_ref<const Members&>()) {
        if (!value.is_structured() && !value.is_number_unsigned()) continue;
        Json& total = member_at(totals, place++, name);
        if (value.is_object()) {
            if (total.is_null()) total = Json::object();
            add_to(total, value);
        } else if (value.is_array()) {
            if (total.is_null()) total = Json::array();
            add_to_counts(total, value);
        } else {
            if (total.is_null()) total = std::uint64_t{0};
            total = total.get<std::uint64_t>() + value.get<std::uint64_t>();
        }
    }
}

// Places without a count at the end are left out.
template <class Counts>
Json array_of(const Counts& counts) {
    Json array = Json::array();
    std::size_t end = counts.size();
    while (end > 0 && counts[end - 1] == 0)
        --end;
    for (std::size_t i = 0; i < end; ++i)
        array.push_back(counts[i]);
    return array;
}

Json describe(const timing::CommandCycles& command) {
    Json json{{"kind", timing::CommandKindNames[static_cast<std::size_t>(command.kind)]},
              {"draw", command.number},
              {"cycles", command.cycles},
              {"bottleneck", command.bottleneck_name()},
              {"bottleneck_cycles", command.bottleneck_cycles()}};
    for (std::size_t i = 0; i < command.moved.size(); ++i) {
        const std::string client(timing::ClientNames[i]);
        if (command.moved[i].read > 0) json[client + "_read_bytes"] = command.moved[i].read;
        if (command.moved[i].written > 0)
            json[client + "_written_bytes"] = command.moved[i].written;
    }
    work::DrawShape::visit(command.shape, [&](auto name, auto, auto, const auto& counts) {
        if (Json array = array_of(counts); !array.empty()) json[name] = std::move(array);
    });
    return json;
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

// Most values are counts: dump(), which can print anything, takes many times as long for one.
void print_value(const Json& json, std::string& text) {
    if (const auto* const count = json.get_ptr<const Json::number_unsigned_t*>())
        fmt::format_to(std::back_inserter(text), "{}", *count);
    else
        text += json.dump();
}

bool is_list(const Json& json) {
    return json.is_array() && std::all_of(json.begin(), json.end(), [](const Json& element) {
               return element.is_primitive();
           });
}

// A member a line; lists of numbers on one. Names are of figures, units and parameters: nothing in
// them is escaped.
void print(const Json& json, const std::string& margin, std::string& text) {
    if (!json.is_structured() || json.empty() || is_list(json)) return print_value(json, text);
    const std::string inner = margin + ' ';
    text += json.is_array() ? '[' : '{';
    bool first = true;
    const auto begin_element = [&] {
        text += std::exchange(first, false) ? "\n" : ",\n";
        text += inner;
    };
    if (json.is_array()) {
        for (const Json& element : json) {
            begin_element();
            print(element, inner, text);
        }
    } else {
        for (const auto& [name, value] : json.get_ref<const Members&>()) {
            begin_element();
            fmt::format_to(std::back_inserter(text), "\"{}\": ", name);
            print(value, inner, text);
        }
    }
    text += '\n' + margin + (json.is_array() ? ']' : '}');
}

std::string printed(const Json& json) {
    std::string text;
    print(json, {}, text);
    return text;
}

// As an element of a member of the whole.
std::string indented(const Json& json) {
    const std::string margin = "  ";
    std::string text = margin;
    print(json, margin, text);
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
        Json& timing = counted["timing"] = object_of(timed.counters);
        if (!timing.contains("total_cycles"))
            timing["total_cycles"] = timed.frame ? timed.frame->cycles : 0;
        counted["histograms"] = Json::object();
        for (const auto& [name, counts] : timed.histograms)
            counted["histograms"][name] = array_of(counts);
    }
    add_to(content_->totals, counted);
    json.update(counted);
    json["overdraw"] = per(counted["functional"].value("fragments_written", std::uint64_t{0}),
                           counted["pixels"].get<std::uint64_t>());
    if (content_->with_timing && timed.frame) {
        Json commands = Json::array();
        for (const timing::CommandCycles& command : timed.frame->commands)
            commands.push_back(describe(command));
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
    const std::string head = printed(json);
    out(std::string_view(head).substr(0, head.size() - 2));
    out(",\n \"frames\": [");
    content_->frames.copy_to(out);
    out(content_->frame_count == 0 ? "]\n}\n" : "\n ]\n}\n");
}

bool StatisticsReport::has_frames() const {
    return content_->frame_count > 0;
}

std::string StatisticsReport::summary() const {
    return summarize(content_->totals, content_->frame_count, content_->clock);
}

} // namespace ffgpu::tools
