#include "tools/diff/command_account.h"

#include "model/memory/pixel_format.h"
#include "tools/diff/account_digest.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace ffgpu::tools {

// The entries between two commands belong to the later one.
void AccountDevice::open() {
    if (is_open_) return;
    is_open_ = true;
    uploads_ = registers_ = 0;
    sink_ = accounts_.begin(number_, frame_);
}

void AccountDevice::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    gpu_.write_memory(at, bytes);
    open();
    if (!sink_) return;
    sink_->begin({AccountStage::Uploads}, {.primitive = uploads_++});
    sink_->integer("address", at);
    sink_->integer("bytes", static_cast<std::int64_t>(bytes.size()));
    sink_->text("content", fmt::format("{:016x}", digest_of(bytes)));
    sink_->end();
}

void AccountDevice::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    gpu_.read_memory(at, bytes);
}

void AccountDevice::submit(const CommandStream& commands) {
    for_each_command(commands.words, [this](const CommandReader& reader) {
        open();
        if (reader.opcode() == Opcode::WriteRegister) {
            tell_register(reader);
            CommandStream one;
            one.words.assign(reader.whole().begin(), reader.whole().end());
            gpu_.submit(one);
        } else {
            carry_out(reader);
        }
    });
}

// The names follow every write; they tell of what a write changes.
void AccountDevice::tell_register(const CommandReader& reader) {
    const std::string text = names_.command(reader);
    if (sink_) tell_text(AccountStage::Registers, text);
}

// "light[2]: enabled 1, ambient 0 0 0 1"
void AccountDevice::tell_text(AccountStage stage, const std::string& line) {
    sink_->begin({stage}, {.primitive = registers_++});
    const std::size_t colon = line.find(": ");
    sink_->text("name", line.substr(0, colon));
    for (std::size_t at = colon; at != std::string::npos;) {
        at += 2;
        const std::size_t end = line.find(", ", at);
        const std::string field = line.substr(at, end - at);
        const std::size_t space = std::min(field.find(' '), field.size());
        sink_->text(field.substr(0, space), field.substr(std::min(space + 1, field.size())));
        at = end;
    }
    sink_->end();
}

void AccountDevice::carry_out(const CommandReader& reader) {
    AccountedCommand command{.number = number_, .frame = frame_, .name = names_.name(reader)};
    if (calls_) command.call = calls_->call();
    if (reader.opcode() == Opcode::Draw || reader.opcode() == Opcode::DrawImage)
        command.draw = next_draw_++;
    CommandStream one;
    one.words.assign(reader.whole().begin(), reader.whole().end());
    if (!sink_) {
        gpu_.submit(one);
    } else {
        tell_text(AccountStage::Command, names_.command(reader));
        counters_before_ = counters();
        StageAccount stages(*sink_);
        gpu_.set_stage_probe(&stages);
        gpu_.submit(one);
        gpu_.finish();
        gpu_.set_stage_probe(nullptr);
        tell_targets(reader);
        tell_counters();
        accounts_.end(command);
    }
    is_open_ = false;
    sink_ = nullptr;
    ++number_;
}

void AccountDevice::tell_targets(const CommandReader& reader) {
    switch (reader.opcode()) {
    case Opcode::Draw:
    case Opcode::DrawImage:
    case Opcode::Clear: {
        const Targets& targets = gpu_.registers().targets;
        for (unsigned i = 0; i < targets.color.size(); ++i)
            tell_surface({AccountStage::Target, i}, targets.color[i]);
        return tell_surface({AccountStage::Target, AccountPart::DepthUnit}, targets.depth);
    }
    case Opcode::CopyRectangle: {
        CommandReader copy(reader.whole());
        copy.next();
        return tell_surface({AccountStage::Target},
                            copy.command<CopyRectangleCommand>().destination);
    }
    default:
        return;
    }
}

void AccountDevice::tell_surface(AccountPart part, const Surface& surface) {
    if (surface.format == Format::None) return;
    const std::size_t pixel_bytes = format_info(surface.format).block_bytes;
    bytes_.resize(surface.width * pixel_bytes);
    for (unsigned sample = 0; sample < surface.samples; ++sample) {
        for (std::uint32_t y = 0; y < surface.height; ++y) {
            const std::uint64_t row = surface.address + sample * surface.plane_bytes() +
                                      std::uint64_t{y} * surface.stride;
            gpu_.read_memory(static_cast<DeviceAddress>(row), bytes_);
            for (std::uint32_t x = 0; x < surface.width; ++x) {
                std::uint32_t value = 0;
                for (std::size_t i = 0; i < pixel_bytes; ++i)
                    value |= std::to_integer<std::uint32_t>(bytes_[x * pixel_bytes + i]) << (8 * i);
                sink_->begin(part,
                             {.kind = AccountPlace::Kind::Pixel,
                              .x = x,
                              .y = y,
                              .sample = static_cast<std::uint8_t>(sample)});
                sink_->color("stored", value);
                sink_->end();
            }
        }
    }
}

std::vector<std::uint64_t> AccountDevice::counters() const {
    std::vector<std::uint64_t> values;
    for (const StatisticsGroup* const group : gpu_.statistics())
        for (const Counter& counter : group->counters())
            values.push_back(counter.value());
    return values;
}

void AccountDevice::tell_counters() {
    sink_->begin({AccountStage::Counters}, {});
    std::size_t i = 0;
    for (const StatisticsGroup* const group : gpu_.statistics())
        for (const Counter& counter : group->counters())
            sink_->integer(counter.name(),
                           static_cast<std::int64_t>(counter.value() - counters_before_[i++]));
    sink_->end();
}

} // namespace ffgpu::tools
