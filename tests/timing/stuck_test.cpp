// A machine that goes on no more tells who keeps the others waiting, and what every unit holds.

#include "model/timing/channel.h"
#include "model/timing/gpu_timing.h"
#include "model/timing/machine_stuck.h"
#include "model/timing/memory_module.h"
#include "model/timing/memory_payload.h"
#include "model/timing/stuck_report.h"
#include "tests/timing/bench_clock.h"
#include "tests/timing/random_work.h"

#include <catch2/catch.hpp>
#include <tlm_utils/simple_target_socket.h>

namespace ffgpu::timing {
namespace {

// Answers at once, but never what `loses` names, nor takes what `refuses` names.
class LosingMemory final : public sc_core::sc_module, public MemoryModule {
public:
    using Choice = std::function<bool(const MemoryRequest&)>;

    LosingMemory(sc_core::sc_module_name name, const Clock& clock, Choice loses, Choice refuses)
        : sc_module(name)
        , loses_(std::move(loses))
        , refuses_(std::move(refuses)) {
        socket_.register_nb_transport_fw(this, &LosingMemory::on_forward);
        SC_HAS_PROCESS(LosingMemory);
        SC_METHOD(on_edge);
        sensitive << clock.edge();
        dont_initialize();
    }

    tlm::tlm_target_socket<>& target() override { return socket_; }

private:
    tlm::tlm_sync_enum
    on_forward(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase, sc_core::sc_time&) {
        const MemoryRequest& request = payload.get_extension<RequestTag>()->request;
        if (refuses_ && refuses_(request)) return tlm::TLM_ACCEPTED;
        if (!loses_ || !loses_(request)) taken_.push_back(&payload);
        phase = tlm::END_REQ;
        return tlm::TLM_UPDATED;
    }

    void on_edge() {
        for (tlm::tlm_generic_payload* const payload : std::exchange(taken_, {})) {
            payload->set_response_status(tlm::TLM_OK_RESPONSE);
            tlm::tlm_phase phase = tlm::BEGIN_RESP;
            sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
            socket_->nb_transport_bw(*payload, phase, delay);
        }
    }

    const Choice loses_, refuses_;
    std::vector<tlm::tlm_generic_payload*> taken_;
    tlm_utils::simple_target_socket<LosingMemory> socket_{"socket"};
};

// The report of a machine that is expected to hang on this memory.
std::string report_of(const LosingMemory::Choice& loses,
                      const LosingMemory::Choice& refuses,
                      const TimingConfig& config = {}) {
    GpuTiming timing(config, 0, [&](const Clock& clock, const MemoryConfig&) {
        return std::make_unique<LosingMemory>("losing", clock, loses, refuses);
    });
    RandomWork work(11);
    for (const auto& command : work.frame(6))
        timing.command(command);
    try {
        timing.end_frame(0);
    } catch (const MachineStuck& stuck) {
        return stuck.what();
    }
    return "the frame ended";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_CASE("a memory that does not answer a client is named, with the unit that waits for it") {
    const std::vector<std::pair<Client, std::string>> cases{
        {Client::Depth, "depth"}, {Client::Texture, "texture"}, {Client::Vertex, "vertex_fetch"}};
    for (const auto& [client, unit] : cases) {
        CAPTURE(unit);
        const std::string report = report_of(
            [silent = client](const MemoryRequest& request) {
                return request.client == silent && !request.write;
            },
            {});
        INFO(report);
        CHECK(has(report, "stuck in cycle "));
        CHECK(has(report, "culprit: memory\n"));
        CHECK(has(report, unit + " waits for arbiter"));
        CHECK(has(report, "arbiter waits for memory"));
        CHECK(has(report, " bytes at 0x"));
        CHECK(has(report, "  " + unit + ": stalled_"));
        CHECK(has(report, " draw ")); // keys of what waits in queues
    }
}

TEST_CASE("every unit of the machine and every queue of theirs is in the report") {
    for (const bool tile_based : {false, true}) {
        TimingConfig config;
        config.texel_l2.enable = true;
        if (tile_based) config.raster.architecture = work::Architecture::TileBased;
        const std::string report =
            report_of([](const MemoryRequest& request) { return !request.write; }, {}, config);
        INFO(report);
        for (const std::string& unit : GpuTiming(config).unit_names())
            if (unit != "memory") CHECK(has(report, "\n  " + unit + ": "));
        for (const char* const queue : {"commands",
                                        "draws",
                                        "vertices",
                                        "clipped",
                                        "setups",
                                        "raster_to_depth",
                                        "fragment_to_depth",
                                        "depth_to_color",
                                        "texel_cache_requests",
                                        "host_requests",
                                        "vertex_cache_responses"})
            CHECK(has(report, "\n    " + std::string(queue) + " "));
        CHECK(has(report, "parameter_fetch_requests ") == tile_based);
    }
}

TEST_CASE("a memory that takes no request is the culprit, though the arbiter stands before it") {
    const std::string report =
        report_of({}, [](const MemoryRequest& request) { return request.client == Client::Color; });
    INFO(report);
    CHECK(has(report, "culprit: memory\n"));
    CHECK(has(report, "not taken"));
}

// --- Wirings of the test's own -------------------------------------------------------------------

// Passes items on; told to, it takes none.
struct Passing : Unit {
    Passing(const char* name, const Clock& clock, Channel<int>* input, Channel<int>* output)
        : Unit(name, clock)
        , in(input)
        , out(output) {}
    Activity step() override {
        if (!in->can_pop()) return Activity::Idle;
        if (refuses) return Activity::Idle;
        if (out && !out->can_push()) return Activity::StalledOutput;
        if (out) out->push(in->front());
        in->pop();
        return Activity::Busy;
    }
    // The test changes `refuses`, of which no channel tells.
    Cycle next_work(Activity) const override { return now() + 1; }
    std::string state() const override { return "holds nothing itself"; }

    Channel<int>*in, *out;
    bool refuses = false;
};

struct Row {
    BenchClock bench;
    Channel<int> first{bench.clock, 2}, second{bench.clock, 3}, third{bench.clock, 4};
    Passing a{"a", bench.clock, &first, &second}, b{"b", bench.clock, &second, &third},
        c{"c", bench.clock, &third, nullptr};

    StuckParts parts() const { return {.pipe = {&a, &b, &c}, .others = {}, .outside = "memory"}; }
    void attach() {
        a.attach();
        b.attach();
        c.attach();
    }
    // With items pushed into the first channel as long as there is a place.
    void fill(int cycles) {
        bench.run_until([this, left = cycles]() mutable {
            if (first.can_push()) first.push(7);
            return --left == 0;
        });
    }
};

TEST_CASE("the unit that takes nothing is the culprit, not those that it holds up") {
    Row row;
    row.first.connect("first", row.c, row.a);
    row.second.connect("second", row.a, row.b);
    row.third.connect("third", row.b, row.c);
    row.c.refuses = true;
    row.attach();
    row.fill(40);
    const Culprit culprit = find_culprit(row.parts());
    CHECK(culprit.names == std::vector<std::string>{"c"});
    const std::string report = describe_stuck(row.parts());
    INFO(report);
    CHECK(has(report, "\n  a: stalled_output since cycle "));
    CHECK(has(report, "holds nothing itself"));
    CHECK(has(report, "\n    third 4/4, first: 7, b was refused"));
    CHECK(has(report, "\n    second 3/3, first: 7, a was refused"));
}

TEST_CASE("units that wait for each other in a circle are named together") {
    Row row; // c's output is a's input, and all are full when c begins to take.
    row.c.out = &row.first;
    row.first.connect("first", row.c, row.a);
    row.second.connect("second", row.a, row.b);
    row.third.connect("third", row.b, row.c);
    row.attach();
    row.c.refuses = true;
    row.fill(40);
    row.c.refuses = false;
    row.bench.run(10);
    const Culprit culprit = find_culprit(row.parts());
    INFO(describe_stuck(row.parts()));
    CHECK(culprit.names == std::vector<std::string>{"c", "a", "b"});
    CHECK(has(describe_stuck(row.parts()), "culprits, in a circle: c, a, b\n"));
}

TEST_CASE("where nobody holds anything, nobody is the culprit") {
    Row row;
    CHECK(find_culprit(row.parts()).names.empty());
}

} // namespace
} // namespace ffgpu::timing
