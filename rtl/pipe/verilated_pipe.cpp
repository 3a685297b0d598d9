#include "rtl/pipe/verilated_pipe.h"

#include "Vfragment_pipe___024root.h"
#include "rtl/pipe/draw_words.h"

#include <ctime>
#include <utility>

namespace ffgpu::rtl {
namespace {

double processor_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Where it was Verilated so, flops wake up with numbers by the seed.
std::unique_ptr<VerilatedContext> powered_up(std::uint64_t seed) {
    auto context = std::make_unique<VerilatedContext>();
    context->randReset(2);
    context->randSeed(static_cast<int>(seed % 0x7fffffff) + 1);
    return context;
}

} // namespace

VerilatedPipe::VerilatedPipe(const PipeOptions& options)
    : options_(options)
    , stalls_(options)
    , context_(powered_up(options.seed))
    , waves_(*dut_, options.waves, "fragment_pipe", options.wave_cycles) {
    reset();
}

void VerilatedPipe::reset() {
    dut_->plane_valid_i = dut_->record_valid_i = dut_->texel_response_valid_next_i = 0;
    dut_->state_write_i = dut_->invalidate_i = 0;
    dut_->rst_ni = 1; // An asynchronous reset is an edge.
    dut_->eval();
    dut_->rst_ni = 0;
    texels_ = {};
    depths_ = {};
    colors_ = {};
    dut_->depth_response_valid_next_i = dut_->color_response_valid_next_i = 0;
    cycle();
    dut_->rst_ni = 1;
    cycle();
    stands_ = false;
    quiet_ = 0;
}

template <class Valid>
void VerilatedPipe::take_back(TargetPort& port, Valid& valid) {
    port.taken();
    valid = 0;
}

// What the memory's ports say in the next cycle is handed over before the edge (pipe_ports.sv);
// until then the inputs are those of this cycle.
void VerilatedPipe::cycle() {
    dut_->clk_i = 0;
    dut_->eval();
    waves_.settled();
    moved_ = false;
    // Flops that wake up with a request in them lose it at the first edge in reset.
    if (dut_->rst_ni) take_requests();
    count_activity();
    const bool depth_taken = dut_->depth_response_valid_next_i && dut_->depth_response_ready_o;
    const bool color_taken = dut_->color_response_valid_next_i && dut_->color_response_ready_o;
    plane_taken_ = dut_->plane_valid_i && dut_->plane_ready_o;
    record_taken_ = dut_->record_valid_i && dut_->record_ready_o;
    ++cycle_;
    if (depth_taken) take_back(depths_, dut_->depth_response_valid_next_i);
    if (color_taken) take_back(colors_, dut_->color_response_valid_next_i);
    drive_memory();
    dut_->clk_i = 1;
    dut_->eval();
    waves_.clocked();
}

// A record or a plane that is taken is a move as well.
template <class Done>
void VerilatedPipe::clock_until(const Done& done) {
    for (bool ends = false; !ends && !stands_;) {
        cycle();
        ends = done();
        quiet_ = moved_ || ends ? 0 : quiet_ + 1;
        stands_ = quiet_ >= options_.quiet_cycles;
    }
}

void VerilatedPipe::drive_memory() {
    dut_->texel_request_ready_next_i = !stalls_.next();
    dut_->depth_request_ready_next_i = !stalls_.next();
    dut_->color_request_ready_next_i = !stalls_.next();
    dut_->depth_store_ready_next_i = !stalls_.next();
    dut_->color_store_ready_next_i = !stalls_.next();
    const std::optional<TexelPort::Answer> answer =
        texels_.take(cycle_, stalls_, !options_.jitters);
    dut_->texel_response_valid_next_i = answer.has_value();
    if (answer) {
        dut_->texel_response_fill_next_i = static_cast<CData>(answer->fill);
        TexelPort::Line line;
        memory_.read(answer->address, line.data(), sizeof line);
        for (unsigned i = 0; i < line.size(); ++i)
            dut_->texel_response_line_next_i[i] = line[i];
    }
    offer(depths_, dut_->depth_response_valid_next_i, dut_->depth_response_next_i);
    offer(colors_, dut_->color_response_valid_next_i, dut_->color_response_next_i);
}

// What has been offered stays until it is taken.
template <class Valid, class Data>
void VerilatedPipe::offer(TargetPort& port, Valid& valid, Data& data) {
    const TargetPort::Words* const words = port.offered(cycle_);
    valid = words && (valid || !stalls_.next());
    if (!valid) return;
    for (unsigned i = 0; i < words->size(); ++i)
        data[i] = (*words)[i];
}

void VerilatedPipe::take_requests() {
    if (dut_->texel_request_valid_o && dut_->texel_request_ready_next_i) {
        texels_.ask(due(), dut_->texel_request_fill_o, dut_->texel_request_address_o);
        moved_ = true;
    }
    // Reads come first: one that is asked beside a store does not see it.
    if (dut_->depth_request_valid_o && dut_->depth_request_ready_next_i)
        depths_.ask(due(), read_words(dut_->depth_request_o));
    if (dut_->color_request_valid_o && dut_->color_request_ready_next_i)
        colors_.ask(due(), read_words(dut_->color_request_o));
    if (dut_->depth_store_valid_o && dut_->depth_store_ready_next_i)
        store(dut_->depth_store_o, false);
    if (dut_->color_store_valid_o && dut_->color_store_ready_next_i)
        store(dut_->color_store_o, true);
}

// As rtl/pipe/pipe_activity.sv tells.
void VerilatedPipe::count_activity() {
    const unsigned events = dut_->rootp->pipe_ports__DOT__u_pipe__DOT__u_activity__DOT__events;
    for (std::size_t unit = 0; unit < PipeUnits; ++unit) {
        activity_.busy[unit] += events >> 2 * unit & 1;
        activity_.stalled[unit] += events >> (2 * unit + 1) & 1;
    }
}

TargetPort::Words VerilatedPipe::read_words(std::uint64_t request) {
    TargetPort::Words words;
    memory_.read(static_cast<std::uint32_t>(request), &words[0], 8);
    memory_.read(static_cast<std::uint32_t>(request >> 32), &words[2], 8);
    moved_ = true;
    return words;
}

// ffgpu_pipe_pkg::target_store_t: data, enables, lower row's address, upper row's; lowest first.
void VerilatedPipe::store(const VlWide<7>& bits, bool is_color) {
    const auto word = [&](unsigned at) {
        return bits[at / 32] >> at % 32 | std::uint64_t{bits[at / 32 + 1]} << (32 - at % 32);
    };
    std::uint64_t lower = bits[0] | std::uint64_t{bits[1]} << 32;
    const std::uint64_t upper = bits[2] | std::uint64_t{bits[3]} << 32;
    if (is_color && options_.faulty_store && color_stores_ == *options_.faulty_store)
        lower ^= 0x0101010101010101;
    color_stores_ += is_color;
    memory_.write(static_cast<std::uint32_t>(word(144)), lower, bits[4] & 0xff);
    memory_.write(static_cast<std::uint32_t>(word(176)), upper, bits[4] >> 8 & 0xff);
    moved_ = true;
}

void VerilatedPipe::forget_textures() {
    finish();
    dut_->invalidate_i = 1;
    cycle();
    dut_->invalidate_i = 0;
    cycle();
}

void VerilatedPipe::begin_draw(const DrawContext& context, std::uint32_t number) {
    began_ = processor_seconds();
    tag_ = !tag_;
    draw_ = number;
    layout_ = context.pixels->layout;
    if ((dut_->idle_o >> tag_ & 1) == 0)
        clock_until([&] { return (dut_->idle_o >> tag_ & 1) != 0; });
    dut_->state_tag_i = tag_;
    drive(dut_->state_i, to_bits(draw_words(context)));
    const auto contexts = texture_contexts(context);
    for (unsigned unit = 0; unit < TextureUnits; ++unit) {
        const Bits bits = to_bits(contexts[unit]);
        for (unsigned i = 0; i < bits.word_count(); ++i)
            dut_->contexts_i[bits.word_count() * unit + i] = bits.words[i];
    }
    dut_->state_write_i = 1;
    cycle();
    dut_->state_write_i = 0;
}

void VerilatedPipe::add(const SetupRecord& record) {
    for (const PlaneWrite& plane : plane_writes(layout_, record)) {
        drive(dut_->plane_i, to_bits(plane));
        dut_->plane_valid_i = 1;
        clock_until([&] { return plane_taken_; });
        dut_->plane_valid_i = 0;
    }
    drive(dut_->record_i, to_bits(RecordWords{tag_, draw_, record}));
    dut_->record_valid_i = 1;
    clock_until([&] { return record_taken_; });
    dut_->record_valid_i = 0;
}

bool VerilatedPipe::finish() {
    if (dut_->idle_o != 3) clock_until([&] { return dut_->idle_o == 3; });
    if (began_ != 0) seconds_ += processor_seconds() - std::exchange(began_, 0);
    if (!stands_) return true;
    reset();
    return false;
}

} // namespace ffgpu::rtl

extern "C" __attribute__((visibility("default"))) ffgpu::rtl::Pipe*
ffgpu_open_rtl_pipe(const ffgpu::rtl::PipeOptions& options, std::string& why) {
    if (!options.waves.empty() && !ffgpu::rtl::CanWriteWaves) {
        why = ffgpu::rtl::NoWaves;
        return nullptr;
    }
    return new ffgpu::rtl::VerilatedPipe(options);
}
