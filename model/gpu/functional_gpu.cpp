// The device interface and the commands; functional_gpu_bin.cpp has draws and bins.

#include "model/gpu/functional_gpu.h"

#include "model/base/check.h"
#include "model/base/float_environment.h"
#include "model/device/extents.h"
#include "model/device/validate.h"
#include "model/memory/copy.h"
#include "model/raster/image_fragments.h"

#include <cstring>
#include <utility>

namespace ffgpu {

FunctionalGpu::FunctionalGpu(const Config& config)
    : config_(config)
    , memory_(config.memory_bytes)
    , pool_(config.threads, config.may_share)
    , geometry_(pool_.threads())
    , stock_(static_cast<int>(config.tile_size), config.bin_bytes)
    , pixel_contexts_(memory_.bytes(), *config_.stages->fragment, config.colors) {
    check(config.threads >= 1, "a GPU needs a thread");
    geometry_[0] = std::make_unique<GeometryWorker>(memory_.bytes(), *config.stages);
    for (unsigned i = 0; i < pool_.threads(); ++i)
        renderers_.push_back(std::make_unique<TileRenderer>(memory_.bytes(), *config.stages));
}

// Other threads may draw still.
FunctionalGpu::~FunctionalGpu() {
    try {
        pool_.wait();
    } catch (...) { // Nobody is left to be told.
    }
}

void FunctionalGpu::set_work_sink(WorkSink* sink, WorkDetail detail) {
    flush();
    registers_sent_ = {};
    check(config_.colors || detail != WorkDetail::Values, "values of colours that are drawn");
    sink_ = sink;
    detail_ = detail;
    journal_.clear();
    for (const auto& renderer : renderers_)
        renderer->set_values(detail == WorkDetail::Values);
}

void FunctionalGpu::hide_from_work(bool hidden) {
    flush();
    hidden_ = hidden;
}

void FunctionalGpu::set_stage_probe(StageProbe* probe) {
    check(config_.colors || !probe, "stages of colours that are drawn");
    flush();
    probe_ = probe;
    renderers_[0]->set_probe(probe);
}

void FunctionalGpu::number_from(std::uint32_t frame, std::uint32_t draw) {
    flush();
    frame_ = frame;
    draw_number_ = draw;
    context_valid_ = pixels_valid_ = false;
}

void FunctionalGpu::reset() {
    flush();
    memory_.clear();
    registers_ = {};
    registers_sent_ = {};
    context_.reset();
    context_valid_ = pixels_valid_ = false;
    journal_.clear();
    cleared_.clear();
    undrawn_.clear();
    missed_colors_ = false;
    frame_ = draw_number_ = 0;
    samples_ = 0;
    samples_pending_ = false;
    for (const auto& worker : geometry_) {
        if (!worker) continue;
        worker->geometry.reset();
        worker->binner.statistics().reset();
    }
    fragment_statistics_.reset();
    host_statistics_.reset();
}

void FunctionalGpu::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    check(memory_.contains(at, bytes.size()), "a write outside device memory");
    before_write(at, bytes.size());
    if (undrawn_.overlaps(at, bytes.size())) undrawn_.remove(at, bytes.size());
    if (!bytes.empty()) std::memcpy(memory_.bytes().data() + at, bytes.data(), bytes.size());
    note_transfer(true, at, bytes.size());
}

void FunctionalGpu::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    check(memory_.contains(at, bytes.size()), "a read outside device memory");
    before_read(at, bytes.size());
    if (!bytes.empty()) std::memcpy(bytes.data(), memory_.bytes().data() + at, bytes.size());
    note_transfer(false, at, bytes.size());
}

std::span<std::byte> FunctionalGpu::settled_memory() {
    flush();
    missed_colors_ = missed_colors_ || !undrawn_.empty();
    cleared_.clear();
    return memory_.bytes();
}

void FunctionalGpu::finish() {
    flush();
}

std::vector<const StatisticsGroup*> FunctionalGpu::statistics() const {
    return {&geometry_[0]->geometry.statistics(),
            &geometry_[0]->binner.statistics(),
            &fragment_statistics_};
}

void FunctionalGpu::submit(const CommandStream& commands) {
    const FloatEnvironment environment;
    for_each_command(commands.words, [this](const CommandReader& reader) { execute(reader); });
}

void FunctionalGpu::execute(const CommandReader& reader) {
    switch (reader.opcode()) {
    case Opcode::WriteRegister:
        return write_register(reader.register_write());
    case Opcode::Draw:
        return draw(reader.command<DrawCommand>());
    case Opcode::Clear:
        return clear(reader.command<ClearCommand>());
    case Opcode::DrawImage:
        return draw_image(reader.command<DrawImageCommand>());
    case Opcode::CopyRectangle:
        return copy(reader.command<CopyRectangleCommand>());
    case Opcode::ResetSampleCounter:
        reader.command<ResetSampleCounterCommand>();
        return reset_samples();
    case Opcode::StoreSampleCounter:
        return store_samples(reader.command<StoreSampleCounterCommand>());
    case Opcode::EndFrame:
        reader.command<EndFrameCommand>();
        return end_frame();
    }
    reader.unknown_opcode();
}

void FunctionalGpu::write_register(const CommandReader::RegisterWrite& write) {
    ++registers_sent_.writes;
    registers_sent_.words += static_cast<std::uint32_t>(write.words.size());
    const RegisterFile::Change change = registers_.write(write);
    if (change == RegisterFile::Change::None) return;
    context_valid_ = false;
    pixels_valid_ = pixels_valid_ && change == RegisterFile::Change::Geometry;
}

void FunctionalGpu::clear(const ClearCommand& command) {
    prepare_context();
    begin_command({.kind = WorkKind::Clear, .clear = command});
    bin().insert_whole(context_->setup.clip);
}

void FunctionalGpu::draw_image(const DrawImageCommand& command) {
    validate(command, memory_.size());
    prepare_context();
    ++primitive_statistics().draws;
    const std::uint64_t bytes = image_bytes(command);
    if (context_->pixels->draws_colors || format_info(command.format).is_depth ||
        command.format == Format::Stencil8)
        before_read(command.address, bytes);
    else
        before_bin_reads(command.address, bytes);
    begin_command({.kind = WorkKind::Image,
                   .number = draw_number_++,
                   .image = std::make_unique<const DrawImageCommand>(command)});
    bins_.reads.add(command.address, bytes);
    bin_serial_ = bin_serial_ || bins_.writes.overlaps(command.address, bytes);
    bin().insert_whole(image_bounds(command, context_->setup.clip, context_->setup.multisample));
    if (command.format != Format::Stencil8 || !records_values()) return;
    flush(); // No quad tells what it wrote.
    const Surface& depth = context_->regs().targets.depth;
    journal_.forget(depth.address, depth.bytes());
}

void FunctionalGpu::copy(const CopyRectangleCommand& command) {
    validate(command, memory_.size());
    flush();
    const Surface& to = command.destination;
    if (undrawn_.overlaps(command.source.address, command.source.bytes()))
        undrawn_.add(to.address, to.bytes());
    copy_rectangle(command, memory_.bytes());
    forget_contents(command.destination.address, command.destination.bytes());
    if (!sink_) return;
    auto work = std::make_shared<WorkBin>();
    const auto [writes, words] = std::exchange(registers_sent_, {});
    work->draws.push_back({.kind = WorkKind::Copy,
                           .frame = frame_,
                           .register_writes = writes,
                           .register_words = words,
                           .state = registers_.snapshot(),
                           .copy = command});
    sink_->bin(std::move(work));
}

void FunctionalGpu::reset_samples() {
    if (samples_pending_) flush();
    samples_ = 0;
}

void FunctionalGpu::store_samples(const StoreSampleCounterCommand& command) {
    validate(command, memory_.size());
    if (samples_pending_) flush();
    before_write(command.address, sizeof samples_);
    std::memcpy(memory_.bytes().data() + command.address, &samples_, sizeof samples_);
}

// Without a listener the next frame may begin while the last bin of this one is drawn.
void FunctionalGpu::end_frame() {
    if (sink_) {
        flush();
        sink_->end_frame(frame_);
    } else if (!bins_.empty()) {
        carry_out();
    }
    ++frame_;
}

} // namespace ffgpu
