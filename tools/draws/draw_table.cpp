#include "tools/draws/draw_table.h"

#include "tools/draws/draw_facts.h"

#include <deque>
#include <utility>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Key = std::pair<timing::CommandKind, std::uint32_t>;

// The machine's entries by what they are; of several of a name in their order.
std::map<Key, std::deque<timing::CommandCycles>> by_name(const timing::FrameTiming& timed) {
    std::map<Key, std::deque<timing::CommandCycles>> named;
    for (const timing::CommandCycles& command : timed.commands)
        named[{command.kind, command.number}].push_back(command);
    return named;
}

std::string client_columns() {
    std::string names;
    for (const std::string_view client : timing::ClientNames)
        names += fmt::format(",{0}_read_bytes,{0}_written_bytes", client);
    return names;
}

std::string costs_text(const timing::CommandCycles& cost) {
    std::string text =
        fmt::format("{},{},{}", cost.cycles, cost.bottleneck_name(), cost.bottleneck_cycles());
    for (const timing::MovedBytes& bytes : cost.moved)
        text += fmt::format(",{},{}", bytes.read, bytes.written);
    return text;
}

} // namespace

DrawTable::DrawTable(const std::string& path, DrawNotes& notes)
    : file_(path)
    , notes_(notes) {
    file_.write(fmt::format("frame,kind,draw,{},texel_cache_misses,cycles,bottleneck,"
                            "bottleneck_cycles{}\n",
                            draw_fact_names(),
                            client_columns()));
}

void DrawTable::command(std::shared_ptr<const work::WholeCommand> command) {
    const WorkDraw& draw = command->draw;
    const bool is_numbered = draw.kind == WorkKind::Draw || draw.kind == WorkKind::Image;
    const DrawNote note = is_numbered ? notes_.take(draw.number) : DrawNote{};
    rows_.push_back({timing::command_kind(draw.kind), draw.number, draw_facts(*command, note)});
}

void DrawTable::texel_line(const timing::QuadName& name, const timing::CacheLine& line) {
    if (line.missed) ++misses_[name.draw];
}

std::uint64_t DrawTable::misses_of(const Row& row) const {
    const bool is_draw =
        row.kind == timing::CommandKind::Draw || row.kind == timing::CommandKind::Image;
    const auto found = is_draw ? misses_.find(row.number) : misses_.end();
    return found == misses_.end() ? 0 : found->second;
}

void DrawTable::write(std::uint64_t frame,
                      std::span<const Row> rows,
                      const timing::FrameTiming* timed) {
    auto costs = timed ? by_name(*timed) : std::map<Key, std::deque<timing::CommandCycles>>{};
    std::string text;
    for (const Row& row : rows) {
        text += fmt::format("{},{},{},{},",
                            frame,
                            timing::CommandKindNames[static_cast<std::size_t>(row.kind)],
                            row.number,
                            row.facts);
        std::deque<timing::CommandCycles>& found = costs[{row.kind, row.number}];
        if (found.empty()) {
            text += ",,," + std::string(2 * timing::Clients, ',') + '\n';
            continue;
        }
        const timing::CommandCycles cost = found.front();
        found.pop_front();
        text += fmt::format("{},{}\n", misses_of(row), costs_text(cost));
    }
    file_.write(text);
    misses_.clear();
}

} // namespace ffgpu::tools
