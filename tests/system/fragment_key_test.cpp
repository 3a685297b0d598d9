// The name of a fragment on real traces: no two fragments share one, nor two samples.

#include "model/gpu/functional_gpu.h"
#include "model/packets/fragment_key.h"
#include "model/work/command_assembler.h"
#include "tests/system/trace_run.h"
#include "tools/frames/frame_source.h"

#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

// Counts the names of a run, and those that were given twice.
class NameCounter : public work::CommandSink {
public:
    void command(std::shared_ptr<const work::WholeCommand> command) override {
        fragments_.clear();
        samples_.clear();
        for (const WorkQuad& quad : command->quads)
            add(quad, command->draw.number);
        fragments += fragments_.size();
        samples += samples_.size();
        twice += repeated(fragments_) + repeated(samples_);
        // A later draw has another number, so that names of two draws differ.
        if (command->quads.empty()) return;
        in_order = in_order && (first_ || command->draw.number > last_draw_);
        last_draw_ = command->draw.number;
        first_ = false;
    }
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

    std::uint64_t fragments = 0, samples = 0, twice = 0;
    bool in_order = true;

private:
    void add(const WorkQuad& quad, std::uint32_t draw) {
        for (unsigned lane = 0; lane < 4; ++lane) {
            if ((quad.covered >> lane & 1) != 0)
                fragments_.push_back({draw, quad.primitive, fragment_sequence(quad, lane)});
            for (unsigned sample = 0; sample < MaxSamples; ++sample)
                if ((quad.samples_covered >> (4 * lane + sample) & 1) != 0)
                    samples_.push_back(
                        {draw, quad.primitive, fragment_sequence(quad, lane, sample)});
        }
    }

    static std::uint64_t repeated(std::vector<FragmentKey>& names) {
        std::sort(names.begin(), names.end());
        std::uint64_t count = 0;
        for (std::size_t i = 1; i < names.size(); ++i)
            count += names[i] == names[i - 1];
        return count;
    }

    std::vector<FragmentKey> fragments_, samples_; // of the command in work
    std::uint32_t last_draw_ = 0;
    bool first_ = true;
};

std::uint64_t counted(const FunctionalGpu& gpu, std::string_view name) {
    for (const StatisticsGroup* const group : gpu.statistics())
        for (const Counter& counter : group->counters())
            if (counter.name() == name) return counter.value();
    return 0;
}

void check_names(const std::string& path, unsigned samples) {
    INFO(path << ", " << samples << " samples");
    FunctionalGpu gpu({.threads = 2, .tile_size = 32});
    NameCounter names;
    work::CommandAssembler assembler(names);
    gpu.set_work_sink(&assembler);
    const auto source =
        open_frame_source(path, gpu, {.warn = [](const std::string&) {}, .samples = samples});
    for (unsigned frame = 0; frame < 2 && source->next(); ++frame) {
    }
    gpu.finish();
    CHECK(names.twice == 0);
    CHECK(names.in_order);
    CHECK(names.fragments == counted(gpu, "fragments_covered"));
    CHECK(names.samples == counted(gpu, "samples_covered"));
    CHECK(names.fragments > 1000);
    CHECK((names.samples > 1000) == (samples > 1));
}

TEST_CASE("No two fragments of a trace share a key, and no two samples") {
    std::vector<std::string> paths;
    for (const std::string& name : own_traces())
        paths.push_back(own_trace(name));
    for (const std::string& name : workload_traces())
        paths.push_back(workload_trace(name));
    for (const std::string& path : paths)
        for (const unsigned samples : {1u, MaxSamples})
            check_names(path, samples);
}

} // namespace
} // namespace ffgpu::tools
