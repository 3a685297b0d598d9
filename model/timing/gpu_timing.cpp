#include "model/timing/gpu_timing.h"

#include "model/timing/machine_checks.h"
#include "model/timing/machine_thread.h"

#include <utility>

// SystemC's library has a main() of its own that calls this; our programs have theirs.
__attribute__((visibility("default"))) int sc_main(int, char**) {
    return 0;
}

namespace ffgpu::timing {
namespace {

constexpr std::size_t MostWaiting = 1 << 16; // quads of commands that wait to be made ready

} // namespace

GpuTiming::GpuTiming(const TimingConfig& config,
                     const Evaluation& evaluation,
                     const MakeMemory& make_memory)
    : context_(std::make_unique<SimulationContext>()) {
    check_machine(config);
    const SimulationContext::Scope scope(*context_);
    machine_ = std::make_unique<Machine>(*context_, config, evaluation, make_memory);
    thread_ = std::make_unique<MachineThread>(*machine_);
    order_ = std::make_unique<work::MachineOrder>(config.work(), *thread_);
    preparation_ = std::make_unique<work::JobThread>(MostWaiting);
}

GpuTiming::~GpuTiming() {
    preparation_.reset();
    thread_.reset();
    const SimulationContext::Scope scope(*context_);
    machine_.reset();
}

void GpuTiming::command(std::shared_ptr<const work::WholeCommand> command) {
    check_values(machine_->config, *command, contents_told_);
    const std::size_t weight = 1 + command->quads.size();
    preparation_->push(
        weight, [this, &preparation = *preparation_, command = std::move(command)]() mutable {
            order_->command(std::move(command));
            tell_parts(preparation);
        });
}

// It would end a scene and give the surface its place: a machine that does not follow values is the
// same with and without.
void GpuTiming::content(const std::shared_ptr<const SurfaceContent>& content) {
    contents_told_ = true;
    if (machine_->config.needs_values().empty()) return;
    preparation_->push(1, [this, &preparation = *preparation_, content] {
        order_->content(content);
        tell_parts(preparation);
    });
}

void GpuTiming::host_transfer(const HostTransfer& transfer) {
    preparation_->push(1, [this, &preparation = *preparation_, transfer] {
        order_->host_transfer(transfer);
        tell_parts(preparation);
    });
}

void GpuTiming::end_frame(std::uint32_t frame) {
    preparation_->push(1, [this, frame] {
        order_->end_frame(frame);
        thread_->show(order_->shown());
    });
    frames_overlap_ ? preparation_->check_failure() : preparation_->drain();
}

// As long as no command waits, of which more can be told at once than of quads. Jobs also run while
// the thread is taken down, when preparation_ is no more.
void GpuTiming::tell_parts(const work::JobThread& preparation) {
    while (!preparation.has_more() && order_->tell_part()) {
    }
}

void GpuTiming::leave_out_figures() {
    machine_->leave_out_figures();
}

void GpuTiming::let_frames_overlap() {
    frames_overlap_ = true;
    thread_->let_frames_overlap();
}

void GpuTiming::post(std::function<void()> job) {
    preparation_->push(1, [this, job = std::move(job)]() mutable {
        order_->tell_parts();
        thread_->post(std::move(job));
    });
}

void GpuTiming::catch_up() {
    try {
        preparation_->drain();
    } catch (...) { // What was made ready as a whole before is carried out.
        thread_->catch_up();
        throw;
    }
    thread_->catch_up();
}

void GpuTiming::set_on_frame(std::function<void(const FrameTiming&)> on_frame) {
    machine_->on_frame = std::move(on_frame);
}

void GpuTiming::set_on_retire(std::function<void(const QuadRetired&)> on_retire) {
    machine_->on_retire = std::move(on_retire);
}

void GpuTiming::set_quad_observer(QuadObserver* observer) {
    machine_->observer = observer;
    machine_->texture.set_observer(observer);
    machine_->depth.set_observer(observer);
    machine_->color.set_observer(observer);
}

void GpuTiming::set_memory_observer(MemoryObserver* observer) {
    machine_->arbiter.set_observer(observer);
}

void GpuTiming::set_command_observer(DramCommandObserver* observer) {
    machine_->memory->set_command_observer(observer);
}

void GpuTiming::set_series_sink(SeriesSink* sink) {
    if (machine_->series) machine_->series->set_sink(sink);
}

void GpuTiming::set_activity_observer(ActivityObserver* observer) {
    const std::vector<Unit*> units = machine_->units();
    for (std::size_t i = 0; i < units.size(); ++i)
        units[i]->set_observer(observer, i);
}

std::vector<std::uint32_t> GpuTiming::block_bytes(const Surface& color, bool depth) {
    const TimingConfig& config = machine_->config;
    const std::uint32_t line_bytes =
        depth ? config.depth_cache.line_bytes : config.color_cache.line_bytes;
    const BlockStates* const states =
        depth ? machine_->blocks.depth.get() : machine_->blocks.color.get();
    const work::PlacedLevel place = order_->place_of(color, depth);
    std::vector<std::uint32_t> bytes;
    if (!states || place.layer_bytes == 0) return bytes;
    for (std::uint32_t y = 0; y < color.height; ++y)
        for (std::uint32_t x = 0; x < color.width; ++x)
            bytes.push_back(states->stored_bytes(quotient(place.address(x, y, 0), line_bytes)));
    return bytes;
}

std::uint64_t GpuTiming::cycles() const {
    return machine_->clock.now();
}

std::vector<const StatisticsGroup*> GpuTiming::statistics() const {
    return machine_->statistics();
}

std::vector<const Histogram*> GpuTiming::histograms() const {
    return machine_->histograms();
}

std::vector<std::string> GpuTiming::unit_names() const {
    std::vector<std::string> names;
    for (Unit* unit : machine_->units())
        names.push_back(unit->account().unit());
    return names;
}

} // namespace ffgpu::timing
