#include "tools/rtl/pipe_cycles.h"

#include "model/base/input_error.h"

#include <utility>

namespace ffgpu::tools {

PipeCycles::PipeCycles(const std::string& path)
    : out_(path) {
    if (!out_) throw InputError(path + ": cannot be written");
    out_ << "draw,cycles";
    for (const std::string_view unit : rtl::PipeUnitNames)
        out_ << ',' << unit << "_busy," << unit << "_stalled";
    out_ << '\n';
}

// In the cycle before, the last of what it took to add it.
void PipeCycles::added(const rtl::Pipe& pipe) {
    if (begin_ == None) begin_ = pipe.cycles() - 1;
}

void PipeCycles::end_draw(const rtl::Pipe& pipe, std::uint32_t draw) {
    const rtl::PipeActivity now = pipe.activity();
    const rtl::PipeActivity before = std::exchange(before_, now);
    if (begin_ == None) return;
    out_ << draw << ',' << pipe.cycles() - begin_;
    for (std::size_t unit = 0; unit < rtl::PipeUnits; ++unit)
        out_ << ',' << now.busy[unit] - before.busy[unit] << ','
             << now.stalled[unit] - before.stalled[unit];
    out_ << '\n';
}

} // namespace ffgpu::tools
