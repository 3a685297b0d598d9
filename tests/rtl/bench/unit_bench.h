// One bench for every unit with a channel in and a channel out: clock, reset, stalls, power-up
// values, and the comparison with the model.
//
// A Unit names its Verilated module (Dut), the packed structs State, Input and Output, and gives
//
//     declare(bins), cover(bins, state, input)     the cases that random vectors have to meet
//     random_state(random), random_input(random, state)
//     expect(state, input, outputs)                by the model's scalar functions alone
//     set_tag(input, tag)                          the bank of registers that the input is under
//     reset()                                      may be left out: forgets what came before
//     settle(output)                               may be left out: clears what does not matter
//     TakesEachCycle = false                       where an item may take longer
//
// Draws follow each other without a gap, under the tags 0 and 1 in turn. A bank is written anew
// when the last item under it has left, as the front end does it.

#pragma once

#include "model/base/check.h"
#include "model/device/pipe_numbers.h"
#include "rtl/bundles/ports.h"
#include "rtl/bundles/waves.h"
#include "tests/rtl/bench/random.h"
#include "tests/rtl/bench/stalls.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::rtl {

template <class Unit>
struct Source {
    std::function<std::optional<typename Unit::State>()> next_draw;  // none: that was all
    std::function<std::optional<typename Unit::Input>()> next_input; // none: end of the draw
};

// For exhaustive tests: draw n of `draws` has state(n) and the inputs input(n, i), i < `inputs`.
template <class Unit, class State, class Input>
Source<Unit> counted_source(unsigned draws, unsigned inputs, State state, Input input) {
    struct Place {
        unsigned draw = 0, at = 0;
    };
    auto place = std::make_shared<Place>();
    return {
        [=]() -> std::optional<typename Unit::State> {
            if (place->draw == draws) return std::nullopt;
            place->at = 0;
            return state(place->draw++);
        },
        [=]() -> std::optional<typename Unit::Input> {
            if (place->at == inputs) return std::nullopt;
            return input(place->draw - 1, place->at++);
        },
    };
}

// Told by ./dev rtl_mutate, which must see the tests fail.
inline bool is_blind() {
    static const bool blind = std::getenv("FFGPU_RTL_BLIND") != nullptr;
    return blind;
}

template <class Unit>
class UnitBench {
public:
    using Dut = typename Unit::Dut;
    using State = typename Unit::State;
    using Input = typename Unit::Input;
    using Output = typename Unit::Output;

    // Flops wake up with numbers of this seed.
    explicit UnitBench(Unit& unit, unsigned seed = 1)
        : unit_(unit) {
        context_->randSeed(static_cast<int>(seed));
        context_->randReset(2);
        dut_ = std::make_unique<Dut>(context_.get());
        dut_->clk_i = 0;
        dut_->in_valid_i = 0;
        dut_->out_ready_i = 0;
        dut_->rst_ni = 1; // An asynchronous reset is an edge.
        dut_->eval();
        waves_ = waves_of_bench();
        reset();
    }

    std::uint64_t compared = 0, mismatches = 0, dependences = 0, stuck = 0;
    std::uint64_t least_latency = ~std::uint64_t{0}; // cycles from an input to an output of its
    std::uint64_t refused = 0; // cycles with an offer that waited, though the receiver took
    std::uint64_t cycles() const { return cycle_; }
    std::string report;

    bool probes_dependences = false;
    unsigned resets_one_in = 0; // cycles; 0: never
    Bins* bins = nullptr;
    // Applied to what the model says, to see that the bench notices.
    std::function<void(Bits&)> corrupt;

    void reset() {
        dut_->rst_ni = 0;
        dut_->eval();
        if (dut_->out_valid_o) note("    valid while in reset\n");
        clock();
        dut_->rst_ni = 1;
        dut_->eval();
        expected_.clear();
        inside_ = {};
        offered_.reset();
        if constexpr (requires { unit_.reset(); }) unit_.reset();
    }

    void run(const Source<Unit>& source, Stall stall, std::uint64_t seed) {
        Random random(seed);
        Stalls stalls(stall, random);
        bool more = begin_draw(source);
        for (unsigned idle = 0; more || offered_ || !expected_.empty();) {
            if (more && !offered_) more = offer(source);
            dut_->in_valid_i = offered_ && (holds_ || stalls.offers());
            dut_->out_ready_i = stalls.takes();
            dut_->eval();
            if (probes_dependences && random.one_in(4)) probe();
            waves_.settled();
            refused += dut_->in_valid_i && !dut_->in_ready_o && dut_->out_ready_i;
            if (exchange())
                idle = 0;
            else if (dut_->out_ready_i) // A receiver that waits now and then begins no new count.
                ++idle;
            if (idle > MostIdleCycles) return fail_stuck();
            if (unasked_ > MostUnasked) return; // A unit that gives for ever takes nothing more.
            clock();
            if (resets_one_in != 0 && random.one_in(resets_one_in)) reset();
        }
    }

private:
    static constexpr unsigned MostIdleCycles = 4000, MostReports = 4, MostUnasked = 1000;

    struct Expected {
        Bits output, state, input;
        unsigned tag;
        std::uint64_t taken_at;
    };

    // FFGPU_RTL_FST=FOLDER: into FOLDER/UNIT_N.fst, the program's N-th bench, from 1.
    Waves waves_of_bench() {
        static unsigned benches = 0;
        const char* const folder = std::getenv("FFGPU_RTL_FST");
        if (!folder) return {};
        check(CanWriteWaves, NoWaves);
        return {*dut_, folder, Unit::Name + ('_' + std::to_string(++benches))};
    }

    void clock() {
        dut_->clk_i = 1;
        dut_->eval();
        waves_.clocked();
        dut_->clk_i = 0;
        ++cycle_;
        context_->timeInc(1);
    }

    // The next draw waits until its bank is free.
    bool begin_draw(const Source<Unit>& source) {
        pending_ = source.next_draw();
        return pending_.has_value();
    }

    bool offer(const Source<Unit>& source) {
        holds_ = false;
        if (pending_) {
            const unsigned tag = tag_ ^ 1;
            if (inside_[tag] != 0) return true;
            tag_ = tag;
            states_[tag] = *pending_;
            state_bits_[tag] = to_bits(*pending_);
            pending_.reset();
            if constexpr (!std::is_same_v<State, NoState>) {
                if (tag == 0) drive(dut_->state_0_i, state_bits_[tag]);
                if (tag == 1) drive(dut_->state_1_i, state_bits_[tag]);
            }
        }
        offered_ = source.next_input();
        if (!offered_) return begin_draw(source);
        unit_.set_tag(*offered_, tag_);
        offered_bits_ = to_bits(*offered_);
        drive(dut_->in_data_i, offered_bits_);
        return true;
    }

    // What the edge to come will transfer. True: something.
    bool exchange() {
        holds_ = dut_->in_valid_i;
        const bool taken = dut_->in_valid_i && dut_->in_ready_o;
        const bool given = dut_->out_valid_o && dut_->out_ready_i;
        if (taken) accept();
        if (given) compare();
        return taken || given;
    }

    void accept() {
        outputs_.clear();
        unit_.expect(states_[tag_], *offered_, outputs_);
        if (bins) unit_.cover(*bins, states_[tag_], *offered_);
        for (const Output& output : outputs_) {
            expected_.push_back(
                {settled(to_bits(output)), state_bits_[tag_], offered_bits_, tag_, cycle_});
            if (corrupt) corrupt(expected_.back().output);
            ++inside_[tag_];
        }
        offered_.reset();
        holds_ = false;
    }

    void compare() {
        const Bits got = settled(sample(dut_->out_data_o, bits_of<Output>()));
        if (expected_.empty()) {
            ++mismatches;
            ++unasked_;
            return note("    an output without an input\n");
        }
        const Expected& front = expected_.front();
        least_latency = std::min(least_latency, cycle_ - front.taken_at);
        ++compared;
        if (!is_blind() && !(got == front.output)) {
            ++mismatches;
            note(differences<Output>(front.output, got));
            if (reports_ <= MostReports) print_again(front);
        }
        --inside_[front.tag];
        expected_.pop_front();
    }

    // Not in the report: Catch breaks what it prints at 80 columns, and this is to be pasted.
    static void print_again(const Expected& failed) {
        std::fputs(("FFGPU_RTL_VECTOR=" + to_hex(failed.state) + '/' + to_hex(failed.input) +
                    " build/tests/rtl/rtl_" + Unit::Name + "_test '[again]'\n")
                       .c_str(),
                   stderr);
    }

    // Without what does not matter, where a unit says so.
    static Bits settled(const Bits& bits) {
        if constexpr (requires(Output & output) { Unit::settle(output); }) {
            auto output = from_bits<Output>(bits);
            Unit::settle(output);
            return to_bits(output);
        } else {
            return bits;
        }
    }

    // In the middle of a cycle: own valid must not reach ready, the receiver's ready not valid or
    // data.
    void probe() {
        const auto ready = dut_->in_ready_o;
        const auto valid = dut_->out_valid_o;
        const Bits data = sample(dut_->out_data_o, bits_of<Output>());
        dut_->in_valid_i = !dut_->in_valid_i;
        dut_->eval();
        dependences += dut_->in_ready_o != ready;
        dut_->in_valid_i = !dut_->in_valid_i;
        dut_->out_ready_i = !dut_->out_ready_i;
        dut_->eval();
        dependences += dut_->out_valid_o != valid;
        dependences += valid && !(sample(dut_->out_data_o, bits_of<Output>()) == data);
        dut_->out_ready_i = !dut_->out_ready_i;
        dut_->eval();
    }

    void fail_stuck() {
        ++stuck;
        note("    nothing moved for " + std::to_string(MostIdleCycles) + " cycles\n");
    }

    void note(const std::string& text) {
        if (++reports_ <= MostReports) report += std::string(Unit::Name) + ":\n" + text;
    }

    Unit& unit_;
    std::uint64_t cycle_ = 0;
    std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
    std::unique_ptr<Dut> dut_;
    Waves waves_;
    unsigned tag_ = 0, reports_ = 0, unasked_ = 0; // outputs without an input
    std::array<unsigned, 2> inside_{};
    std::array<State, 2> states_{};
    std::array<Bits, 2> state_bits_{};
    std::optional<State> pending_;
    std::optional<Input> offered_;
    Bits offered_bits_;
    bool holds_ = false; // valid was up, and must stay
    std::deque<Expected> expected_;
    std::vector<Output> outputs_;
};

} // namespace ffgpu::rtl
