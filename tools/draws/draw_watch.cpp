#include "tools/draws/draw_watch.h"

#include "tools/frames/numbered_draws.h"

#include <utility>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

void append(CommandStream& stream, std::span<const std::uint32_t> words) {
    stream.words.insert(stream.words.end(), words.begin(), words.end());
}

} // namespace

DrawWatch::DrawWatch(Device& device, const FrameRange& range, Listener listener)
    : device_(device)
    , range_(range)
    , listener_(std::move(listener)) {}

void DrawWatch::submit(const CommandStream& commands) {
    for_each_command(commands.words, [this](const CommandReader& reader) {
        if (is_numbered(reader.opcode())) return draw(reader);
        if (reader.opcode() == Opcode::WriteRegister) registers_.write(reader.register_write());
        append(waiting_, reader.whole());
    });
    flush();
}

void DrawWatch::draw(const CommandReader& reader) {
    WatchedDraw draw{.number = next_++, .is_image = reader.opcode() == Opcode::DrawImage};
    DrawCommand command;
    if (!draw.is_image) command = reader.command<DrawCommand>();
    draw.primitive = command.primitive;
    listener_.before(draw);
    if (range_.contains(draw.number) || command.output == DrawOutput::Feedback) {
        append(waiting_, reader.whole());
    } else {
        waiting_.add(DrawCommand{}); // of no vertices
    }
    if (!listener_.behind) return;
    flush();
    listener_.behind(draw.number, registers_.values().targets);
}

std::string DrawWatch::missing_draws() const {
    const bool to_the_end = range_.last == FrameRange{}.last;
    if (to_the_end && range_.first == 0) return {};
    if (first_ == next_) return "--draws: there are no draws";
    if (range_.first >= next_ || range_.last < first_)
        return fmt::format(
            "--draws: the draws are {} to {}: none of those wanted is there", first_, next_ - 1);
    if (to_the_end || range_.last < next_) return {};
    return fmt::format("--draws: the last draw is {}", next_ - 1);
}

void DrawWatch::flush() {
    if (waiting_.words.empty()) return;
    device_.submit(std::exchange(waiting_, {}));
}

} // namespace ffgpu::tools
