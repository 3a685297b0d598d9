#include "model/timing/stuck_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::timing {
namespace {

const std::string& name_of(const Unit& unit) {
    return unit.account().unit();
}

std::string_view activity_name(const Unit& unit) {
    return ActivityNames[static_cast<std::size_t>(unit.activity())];
}

// A place that it wants and does not get, of the kind that it waits for.
const Link* refused(const Unit& unit, bool requests) {
    for (const Link* const link : unit.outputs())
        if (link->is_refused() && link->carries_requests() == requests) return link;
    return nullptr;
}

// Whom it asks for data.
const Link* asking(const Unit& unit) {
    for (const Link* const link : unit.outputs())
        if (link->carries_requests()) return link;
    return nullptr;
}

const Link* wait_of(const Unit& unit) {
    switch (unit.activity()) {
    case Activity::StalledOutput:
        return refused(unit, false);
    case Activity::StalledRequests:
        if (const Link* const link = refused(unit, true)) return link;
        return asking(unit); // Its own fills are at their limit.
    case Activity::StalledMemory:
        return asking(unit);
    default:
        return nullptr;
    }
}

bool holds_something(const Unit& unit) {
    const auto is_stalled = [](Activity activity) {
        return activity != Activity::Idle && activity != Activity::Busy;
    };
    return is_stalled(unit.activity()) ||
           std::any_of(unit.inputs().begin(), unit.inputs().end(), [](const Link* link) {
               return link->items() > 0;
           });
}

// The last of the pipe, else any; null: all are empty.
const Unit* last_with_work(const StuckParts& parts) {
    for (std::size_t i = parts.pipe.size(); i-- > 0;)
        if (holds_something(*parts.pipe[i])) return parts.pipe[i];
    for (const Unit* const unit : parts.others)
        if (holds_something(*unit) || unit->waits_outside()) return unit;
    return nullptr;
}

void add_unit(const Unit& unit, std::string& text) {
    text +=
        fmt::format("  {}: {} since cycle {}", name_of(unit), activity_name(unit), unit.since());
    if (const std::string state = unit.state(); !state.empty()) text += "; " + state;
    text += '\n';
    for (const Link* const link : unit.inputs()) {
        text += fmt::format("    {} {}/{}", link->name(), link->items(), link->places());
        if (const std::string key = link->front_key(); !key.empty()) text += ", first: " + key;
        if (link->is_refused()) text += ", " + name_of(*link->producer()) + " was refused";
        text += '\n';
    }
}

} // namespace

Culprit find_culprit(const StuckParts& parts) {
    Culprit culprit;
    std::vector<const Unit*> way;
    for (const Unit* unit = last_with_work(parts); unit;) {
        const auto before = std::find(way.begin(), way.end(), unit);
        if (before != way.end()) {
            culprit.names.clear();
            for (auto in_circle = before; in_circle != way.end(); ++in_circle)
                culprit.names.push_back(name_of(**in_circle));
            return culprit;
        }
        way.push_back(unit);
        culprit.names = {name_of(*unit)};
        const Link* const wait = wait_of(*unit);
        if (wait) {
            culprit.waits.push_back(fmt::format(
                "{} waits for {} ({})", name_of(*unit), name_of(*wait->consumer()), wait->name()));
            unit = wait->consumer();
        } else if (unit->waits_outside()) {
            culprit.waits.push_back(name_of(*unit) + " waits for " + parts.outside);
            culprit.names = {parts.outside};
            unit = nullptr;
        } else {
            unit = nullptr;
        }
    }
    return culprit;
}

std::string describe_stuck(const StuckParts& parts) {
    const Culprit culprit = find_culprit(parts);
    std::string text;
    if (culprit.names.empty())
        text = "culprit: unknown, no unit holds anything\n";
    else if (culprit.names.size() == 1)
        text = "culprit: " + culprit.names[0] + "\n";
    else
        text = fmt::format("culprits, in a circle: {}\n", fmt::join(culprit.names, ", "));
    for (const std::string& wait : culprit.waits)
        text += "  " + wait + '\n';
    text += "units, each with its inputs:\n";
    for (const auto* const units : {&parts.pipe, &parts.others})
        for (const Unit* const unit : *units)
            add_unit(*unit, text);
    return text;
}

} // namespace ffgpu::timing
