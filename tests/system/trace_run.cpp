#include "tests/system/trace_run.h"

#include "model/device/command_reader.h"
#include "model/device/primitive_vertices.h"
#include "model/gpu/functional_gpu.h"
#include "model/timing/gpu_timing.h"
#include "model/work/command_assembler.h"
#include "tools/frames/frame_source.h"
#include "tools/record/work_fan_out.h"
#include "tools/report/frame_image.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

// Passes commands on one by one, and finishes each.
class RegroupingDevice : public Device {
public:
    RegroupingDevice(Device& device, bool halves)
        : device_(device)
        , halves_(halves) {}

    std::uint64_t memory_size() const override { return device_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        device_.write_memory(at, bytes);
    }
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override {
        device_.read_memory(at, bytes);
    }
    void submit(const CommandStream& commands) override {
        CommandReader reader(commands.words);
        while (reader.next()) {
            CommandStream one;
            if (reader.opcode() == Opcode::Draw && halves_) {
                draw_halves(reader.command<DrawCommand>());
                continue;
            }
            const auto words = reader.whole();
            one.words.insert(one.words.end(), words.begin(), words.end());
            pass(one);
        }
    }
    void finish() override { device_.finish(); }
    std::vector<const StatisticsGroup*> statistics() const override { return device_.statistics(); }

private:
    void pass(const CommandStream& commands) {
        device_.submit(commands);
        device_.finish();
    }

    void draw(const DrawCommand& command) {
        CommandStream one;
        one.add(command);
        pass(one);
    }

    void draw_halves(DrawCommand command) {
        const unsigned each = vertices_of_one(command.primitive);
        if (!is_independent(command.primitive) || command.count < 2 * each ||
            command.output == DrawOutput::Feedback)
            return draw(command);
        const std::uint32_t count = command.count;
        command.count = count / each / 2 * each;
        draw(command);
        if (command.index_type == IndexType::None) {
            command.first += command.count;
        } else {
            const unsigned index_bytes = command.index_type == IndexType::U16 ? 2 : 4;
            command.index_address += command.count * index_bytes;
        }
        command.count = count - command.count;
        command.continue_line_stipple = true;
        draw(command);
    }

    Device& device_;
    bool halves_;
};

void add(Counters& to, const std::vector<const StatisticsGroup*>& groups) {
    for (const StatisticsGroup* const group : groups)
        for (const Counter& counter : group->counters())
            to[std::string(counter.name())] = counter.value();
}

std::vector<std::string> traces_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".trace") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class NullSink : public WorkSink {
public:
    void bin(std::shared_ptr<const WorkBin>) override {}
    void end_frame(std::uint32_t) override {}
};

} // namespace

std::ostream& operator<<(std::ostream& out, const Picture& picture) {
    return out << fmt::format("frame {}: {}x{} {:016x}",
                              picture.frame,
                              picture.width,
                              picture.height,
                              picture.hash);
}

Picture picture_of(std::uint64_t frame, const Image& image) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const std::uint8_t byte : image.rgb)
        hash = (hash ^ byte) * 0x100000001b3;
    return {frame, image.width, image.height, hash};
}

Run run_trace(const std::string& path, const RunOptions& options) {
    Run run;
    FunctionalGpu gpu({.threads = options.threads,
                       .tile_size = options.tile_size,
                       .bin_bytes = options.bin_bytes,
                       .stages = options.reference ? &ReferenceStages : &FastStages});
    RegroupingDevice regrouping(gpu, options.grouping == Grouping::Halves);
    const bool as_given = options.grouping == Grouping::AsGiven;
    Device& device = as_given ? static_cast<Device&>(gpu) : regrouping;

    NullSink null;
    WorkFanOut sinks;
    std::unique_ptr<timing::GpuTiming> timing;
    std::optional<work::CommandAssembler> assembler;
    if (options.record_work) sinks.add(null);
    if (options.timing) {
        timing = std::make_unique<timing::GpuTiming>(*options.timing);
        timing->set_on_frame([&run](const timing::FrameTiming& frame) {
            run.cycles.push_back(frame.cycles);
            for (const timing::CommandCycles& command : frame.commands)
                run.draw_cycles.emplace_back(command.number, command.cycles);
        });
        sinks.add(assembler.emplace(*timing));
    }
    const bool values = options.timing && !options.timing->needs_values().empty();
    if (!sinks.empty()) gpu.set_work_sink(&sinks, values ? WorkDetail::Values : WorkDetail::Masks);

    const auto source = open_frame_source(path, device, {.warn = [](const std::string&) {}});
    while (const auto frame = source->next()) {
        device.finish();
        gpu.hide_from_work(true); // To look at a picture is no work of the machine's.
        run.pictures.push_back(picture_of(frame->number, read_surface(device, frame->picture)));
        gpu.hide_from_work(false);
        if (frame->number >= options.last_frame) break;
    }
    add(run.functional, gpu.statistics());
    add(run.host, {&gpu.host_statistics()});
    if (timing) add(run.timed, timing->statistics());
    return run;
}

std::vector<std::string> own_traces() {
    return {"chrome", "corridor", "light_maps"};
}

std::vector<std::string> gallery_traces() {
    std::vector<std::string> names = traces_in(FFGPU_SOURCE_DIR "/traces/gallery");
    for (std::string& name : names)
        name.insert(0, "gallery/");
    return names;
}

std::string own_trace(const std::string& name) {
    return FFGPU_SOURCE_DIR "/traces/" + name + ".trace";
}

fs::path workloads() {
    if (const char* const path = std::getenv("FFGPU_WORKLOADS")) return path;
    return fs::path(FFGPU_SOURCE_DIR) / "../shared/workloads";
}

std::vector<std::string> workload_traces() {
    const fs::path folder = workloads() / "traces";
    if (!fs::is_directory(folder)) {
        WARN("skipped: traces of real programs are not in " << folder.string());
        return {};
    }
    return traces_in(folder);
}

std::string workload_trace(const std::string& name) {
    return (workloads() / "traces" / (name + ".trace")).string();
}

} // namespace ffgpu::tools
