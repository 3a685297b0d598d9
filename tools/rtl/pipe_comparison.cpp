#include "tools/rtl/pipe_comparison.h"

#include "model/base/input_error.h"
#include "model/device/command_reader.h"
#include "tools/rtl/pipe_reasons.h"
#include "tools/rtl/rtl_library.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

void append(CommandStream& stream, const CommandReader& reader) {
    stream.words.insert(stream.words.end(), reader.whole().begin(), reader.whole().end());
}

} // namespace

std::unique_ptr<rtl::Pipe> open_rtl_pipe(const rtl::PipeOptions& options) {
    const auto open =
        reinterpret_cast<rtl::OpenPipe>(rtl_function("ffgpu_pipe.so", rtl::OpenPipeName));
    std::string why;
    rtl::Pipe* const pipe = open(options, why);
    if (!pipe) throw InputError(why);
    return std::unique_ptr<rtl::Pipe>(pipe);
}

PipeComparison::PipeComparison(const rtl::PipeOptions& options, const std::string& cycles)
    : pipe_(open_rtl_pipe(options)) {
    if (!cycles.empty()) cycles_.emplace(cycles);
}

void PipeComparison::attach(Device& device, FunctionalGpu& gpu) {
    device_ = &device;
    gpu_ = &gpu;
    counted_fragments_ = model_fragments();
    drawn_ = std::make_unique<FunctionalGpu>(
        FunctionalGpu::Config{.memory_bytes = device.memory_size()});
    records_ = std::make_unique<PipeRecords>(drawn_->settled_memory());
    pipe_->set_memory(drawn_->settled_memory());
}

void PipeComparison::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    device_->write_memory(at, bytes);
    drawn_->write_memory(at, bytes);
}

void PipeComparison::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    device_->read_memory(at, bytes);
}

// The model goes first: it says what is wrong with a command.
void PipeComparison::submit(const CommandStream& commands) {
    CommandStream part;
    const auto submit_part = [&] {
        device_->submit(part);
        drawn_->submit(part);
        part.words.clear();
    };
    for_each_command(commands.words, [&](const CommandReader& reader) {
        const Opcode opcode = reader.opcode();
        if (opcode != Opcode::Draw && opcode != Opcode::DrawImage) return append(part, reader);
        submit_part();
        CommandStream command;
        append(command, reader);
        device_->submit(command);
        if (opcode == Opcode::DrawImage) return draw(command, "drawn pixels");
        const auto plain = reader.command<DrawCommand>();
        if (plain.output == DrawOutput::Feedback) {
            drawn_->submit(command);
            ++next_draw_;
        } else {
            draw(command, draw_by_pipe(plain));
        }
    });
    submit_part();
    if (cycles_) cycles_->write(); // Not above: a full disk is no command's fault.
}

// What the pipe has not drawn for this reason, the GPU that it draws on does.
void PipeComparison::draw(const CommandStream& command, std::string reason) {
    if (!reason.empty()) drawn_->submit(command);
    by_pipe_ += reason.empty();
    compare(reason);
    ++next_draw_;
    ++draws_;
}

std::string PipeComparison::draw_by_pipe(const DrawCommand& command) {
    drawn_->settled_memory();
    records_->make(drawn_->registers(), next_draw_, command);
    std::string reason = reason_against_pipe(*records_);
    if (!reason.empty()) return reason;
    if (records_->context().pixels->units != 0) pipe_->forget_textures();
    pipe_->begin_draw(records_->context(), next_draw_);
    if (cycles_) cycles_->begin_draw();
    records_->for_each([&](const SetupRecord& record) {
        pipe_->add(record);
        if (cycles_) cycles_->added(*pipe_);
    });
    stands_ = !pipe_->finish();
    if (cycles_) cycles_->end_draw(*pipe_, next_draw_);
    return {};
}

void PipeComparison::compare(const std::string& reason) {
    gpu_->hide_from_work(true);
    PipeDifference found{.draw = next_draw_, .stands = std::exchange(stands_, false)};
    found.target = targets_.compare(gpu_->registers().targets, *gpu_, *drawn_);
    gpu_->hide_from_work(false);
    const std::uint64_t fragments = model_fragments();
    fragments_[reason] += fragments - std::exchange(counted_fragments_, fragments);
    if (found.target.target.empty() && !found.stands) return;
    ++different_;
    if (!difference_) difference_ = found;
}

std::uint64_t PipeComparison::model_fragments() const {
    for (const StatisticsGroup* group : gpu_->statistics())
        for (const Counter& counter : group->counters())
            if (counter.name() == "fragments_covered") return counter.value();
    return 0;
}

void PipeComparison::finish() {
    device_->finish();
    drawn_->finish();
}

std::vector<const StatisticsGroup*> PipeComparison::statistics() const {
    return device_->statistics();
}

std::string PipeComparison::share_text() const {
    std::uint64_t all = 0;
    for (const auto& [reason, fragments] : fragments_)
        all += fragments;
    std::string text;
    for (const auto& [reason, fragments] : fragments_)
        if (fragments != 0)
            text += fmt::format("rtl: fragment_pipe: {} fragments, {:.2f} %{}\n",
                                fragments,
                                100 * static_cast<double>(fragments) / static_cast<double>(all),
                                reason.empty() ? "" : " by the model: " + reason);
    return text;
}

void PipeComparison::commit() {
    if (cycles_) cycles_->commit();
}

std::string PipeComparison::summary() const {
    std::string text = share_text();
    if (pipe_->seconds() > 0)
        text += fmt::format("rtl: fragment_pipe: {} cycles, {:.3f} million cycles a second of the "
                            "host's processor\n",
                            pipe_->cycles(),
                            1e-6 * static_cast<double>(pipe_->cycles()) / pipe_->seconds());
    if (equal())
        return text + fmt::format("rtl: {} draws, {} by the pipe, target bytes equal to the "
                                  "model's after each\n",
                                  draws_,
                                  by_pipe_);
    text += fmt::format("rtl: draw {} is the first that parts\n", difference_->draw);
    if (difference_->stands) text += "rtl:   the pipe does not end it\n";
    return text + target_text(difference_->target) +
           fmt::format("rtl: {} of {} draws part\n", different_, draws_);
}

} // namespace ffgpu::tools
