#include "tools/report_page/run_figures.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t KnownVersion = 2;

std::uint64_t number_of(const Json& object, const char* key) {
    const Json& value = object.at(key);
    if (!value.is_number_unsigned()) throw InputError(fmt::format("{}: expected a count", key));
    return value.get<std::uint64_t>();
}

// Frames may lack a figure that others have; they have none of it.
class Columns {
public:
    explicit Columns(FigureTable& table)
        : table_(table) {
        for (std::size_t i = 0; i < table.size(); ++i)
            places_[table[i].first] = i;
    }

    void add(const Json& figures, std::size_t frame) {
        for (const auto& [name, value] : figures.items()) {
            const auto [place, is_new] = places_.try_emplace(name, table_.size());
            if (is_new) table_.emplace_back(name, FigureColumn{});
            FigureColumn& column = table_[place->second].second;
            column.resize(frame);
            column.push_back(number_of(figures, name.c_str()));
        }
    }

private:
    FigureTable& table_;
    std::map<std::string, std::size_t> places_;
};

struct Lanes {
    std::uint64_t quads = 0, lanes = 0;
};

Lanes lanes_of(const Json& command, const char* key) {
    Lanes sum;
    if (!command.contains(key)) return sum;
    const auto counts = command.at(key).get<FigureColumn>();
    for (std::size_t lanes = 0; lanes < counts.size(); ++lanes) {
        sum.quads += counts[lanes];
        sum.lanes += lanes * counts[lanes];
    }
    return sum;
}

RunCommand command_of(const Json& entry) {
    RunCommand command{.kind = entry.at("kind"),
                       .draw = number_of(entry, "draw"),
                       .cycles = number_of(entry, "cycles"),
                       .bottleneck_cycles = number_of(entry, "bottleneck_cycles"),
                       .bottleneck = entry.at("bottleneck")};
    for (const char* const pieces : {"piece_pixels", "piece_samples"})
        command.pieces += lanes_of(entry, pieces).quads;
    const Lanes covered = lanes_of(entry, "quad_lanes_covered");
    command.quads = covered.quads;
    command.covered = covered.lanes;
    command.written = lanes_of(entry, "quad_lanes_written").lanes;
    return command;
}

// What the host moved, thousands of entries a frame, becomes one of each kind. Its bottleneck is
// the one that most of its cycles waited for.
class HostTransfers {
public:
    void add(const RunCommand& transfer) {
        const auto [place, is_new] = sums_.try_emplace(transfer.kind, transfer);
        if (is_new) {
            place->second.count = 0;
            place->second.cycles = 0;
        }
        ++place->second.count;
        place->second.cycles += transfer.cycles;
        waits_[transfer.kind][transfer.bottleneck] += transfer.bottleneck_cycles;
    }

    void append_to(std::vector<RunCommand>& commands) {
        for (auto& [kind, sum] : sums_) {
            const auto& waits = waits_[kind];
            const auto most =
                std::max_element(waits.begin(), waits.end(), [](const auto& a, const auto& b) {
                    return a.second < b.second;
                });
            sum.draw = 0;
            sum.bottleneck = most->first;
            sum.bottleneck_cycles = most->second;
            commands.push_back(sum);
        }
    }

private:
    std::map<std::string, RunCommand> sums_;
    std::map<std::string, std::map<std::string, std::uint64_t>> waits_;
};

std::vector<RunCommand> commands_of(const Json& entries) {
    std::vector<RunCommand> commands;
    HostTransfers transfers;
    for (const Json& entry : entries) {
        RunCommand command = command_of(entry);
        if (command.kind == "host_write" || command.kind == "host_read")
            transfers.add(command);
        else
            commands.push_back(std::move(command));
    }
    transfers.append_to(commands);
    return commands;
}

class Reader {
public:
    explicit Reader(const FrameRange& range)
        : range_(range) {}

    void frame(const Json& frame) {
        const std::uint64_t number = number_of(frame, "frame");
        if (!range_.contains(number)) return;
        if (!figures_.frames.empty() && number <= figures_.frames.back().number)
            throw InputError(fmt::format("frame {}: is not behind the one before", number));
        const std::size_t place = figures_.frames.size();
        figures_.frames.push_back({.number = number,
                                   .width = number_of(frame, "width"),
                                   .height = number_of(frame, "height"),
                                   .api_calls = number_of(frame, "api_calls"),
                                   .milliseconds = frame.value("milliseconds", 0.0),
                                   .overdraw = frame.value("overdraw", 0.0)});
        functional_.add(frame.at("functional"), place);
        if (!frame.contains("timing")) return;
        timing_.add(frame.at("timing"), place);
        figures_.commands.push_back(commands_of(frame.at("commands")));
        for (const auto& [name, counts] : frame.at("histograms").items())
            add_histogram(figures_.histograms[name], counts.get<FigureColumn>());
    }

    void rest(const Json& file) {
        if (number_of(file, "schema_version") != KnownVersion)
            throw InputError(fmt::format("schema_version: expected {}", KnownVersion));
        if (!file.contains("frames")) throw InputError("expected frames");
        if (!file.contains("configuration") || file.at("configuration").empty()) return;
        const Json parameters = file.at("configuration").flatten();
        for (const auto& [name, value] : parameters.items())
            figures_.configuration.emplace_back(dotted(name), value);
    }

    RunFigures take() {
        const std::size_t count = figures_.frames.size();
        if (figures_.has_timing() && figures_.commands.size() != count)
            throw InputError("only some frames have a timing");
        for (FigureTable* const table : {&figures_.functional, &figures_.timing})
            for (auto& [name, column] : *table)
                column.resize(count);
        return std::move(figures_);
    }

private:
    static void add_histogram(FigureColumn& sums, const FigureColumn& counts) {
        sums.resize(std::max(sums.size(), counts.size()));
        for (std::size_t i = 0; i < counts.size(); ++i)
            sums[i] += counts[i];
    }

    // Of "/texel_cache/ways".
    static std::string dotted(std::string pointer) {
        std::replace(pointer.begin(), pointer.end(), '/', '.');
        return pointer.substr(1);
    }

    const FrameRange range_;
    RunFigures figures_;
    Columns functional_{figures_.functional}, timing_{figures_.timing};
};

// Frames are read one by one and thrown away: they are nearly all of the file.
RunFigures parse(std::istream& file, const FrameRange& range) {
    constexpr int KeyDepth = 1, FrameDepth = 2;
    Reader reader(range);
    std::string key;
    const auto look = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::key && depth == KeyDepth) key = parsed;
        if (event != Json::parse_event_t::object_end || depth != FrameDepth || key != "frames")
            return true;
        reader.frame(parsed);
        return false;
    };
    reader.rest(Json::parse(file, look));
    return reader.take();
}

} // namespace

std::uint64_t RunFigures::frame_cycles(std::size_t frame) const {
    const FigureColumn* const cycles = find_figure(timing, "total_cycles");
    return cycles ? (*cycles)[frame] : 0;
}

const FigureColumn* find_figure(const FigureTable& table, const std::string& name) {
    const auto found = std::find_if(
        table.begin(), table.end(), [&](const auto& entry) { return entry.first == name; });
    return found == table.end() ? nullptr : &found->second;
}

std::uint64_t total(const FigureColumn& column) {
    return std::accumulate(column.begin(), column.end(), std::uint64_t{0});
}

RunFigures read_run_figures(const std::string& folder, const FrameRange& range) {
    const std::string path = (std::filesystem::path(folder) / "stats.json").string();
    if (!std::filesystem::is_directory(folder)) throw InputError(folder + ": is no folder");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw InputError(folder + ": has no stats.json that can be read: it is not what replay, "
                                  "run or time wrote");
    try {
        RunFigures figures = parse(file, range);
        if (figures.frames.empty()) throw InputError("has none of the frames");
        return figures;
    } catch (const Json::parse_error& error) {
        throw InputError(fmt::format("{}: is cut off or damaged at byte {}", path, error.byte));
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: is no statistics file: {}", path, error.what()));
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.what());
    }
}

} // namespace ffgpu::tools
