#include "tools/rtl/pipe_cycles.h"

#include <fmt/format.h>

namespace ffgpu::tools {

PipeCycles::PipeCycles(const std::string& path)
    : file_(path) {
    std::string names = "draw,cycles";
    for (const std::string_view unit : rtl::PipeUnitNames)
        names += fmt::format(",{0}_busy,{0}_stalled", unit);
    file_.write(names + '\n');
}

// In the cycle before, the last of what it took to add it.
void PipeCycles::added(const rtl::Pipe& pipe) {
    if (begin_ == None) begin_ = pipe.cycles() - 1;
}

void PipeCycles::end_draw(const rtl::Pipe& pipe, std::uint32_t draw) {
    const rtl::PipeActivity now = pipe.activity();
    const rtl::PipeActivity before = std::exchange(before_, now);
    if (begin_ == None) return;
    lines_ += fmt::format("{},{}", draw, pipe.cycles() - begin_);
    for (std::size_t unit = 0; unit < rtl::PipeUnits; ++unit)
        lines_ += fmt::format(
            ",{},{}", now.busy[unit] - before.busy[unit], now.stalled[unit] - before.stalled[unit]);
    lines_ += '\n';
}

void PipeCycles::commit() {
    write();
    file_.commit();
}

} // namespace ffgpu::tools
