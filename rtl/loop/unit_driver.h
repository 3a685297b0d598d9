// Clocks a Verilated unit: the inputs of one draw in, its outputs out.
//
// A Unit names its module (Dut) and the packed structs State, Input and Output, as a test's does,
// and may say how many outputs come of inputs (outputs_of); otherwise it has done when it takes the
// next input and shows no output for a while.

#pragma once

#include "rtl/bundles/ports.h"
#include "rtl/bundles/state.h"
#include "rtl/bundles/waves.h"
#include "rtl/loop/loop_log.h"

#include <memory>
#include <span>
#include <vector>

namespace ffgpu::rtl {

template <class Unit>
class UnitDriver {
public:
    using State = typename Unit::State;
    using Input = typename Unit::Input;
    using Output = typename Unit::Output;

    UnitDriver() {
        dut_->clk_i = 0;
        dut_->in_valid_i = 0;
        dut_->out_ready_i = 1;
        dut_->rst_ni = 1; // An asynchronous reset is an edge.
        dut_->eval();
        dut_->rst_ni = 0;
        clock();
        dut_->rst_ni = 1;
    }

    // Valid until the next call. The state stands in a bank, and its opposite in the other one: a
    // unit that takes a bit of the wrong bank shows it.
    std::span<const Output>
    run(const State& state, std::span<const Input> inputs, unsigned bank = 0) {
        bank_ = bank;
        if constexpr (!std::is_same_v<State, NoState>) {
            drive(bank == 0 ? dut_->state_0_i : dut_->state_1_i, to_bits(state));
            drive(bank == 0 ? dut_->state_1_i : dut_->state_0_i, opposite(to_bits(state)));
        }
        outputs_.clear();
        std::size_t taken = 0;
        for (unsigned quiet = 0; !is_done(inputs, taken, quiet);) {
            dut_->in_valid_i = taken < inputs.size();
            if (dut_->in_valid_i) drive(dut_->in_data_i, with_tag<Input>(to_bits(inputs[taken])));
            dut_->eval();
            waves_.settled();
            const bool takes = dut_->in_valid_i && dut_->in_ready_o;
            quiet = takes || dut_->out_valid_o || !dut_->in_ready_o ? 0 : quiet + 1;
            taken += takes;
            if (dut_->out_valid_o) receive();
            clock();
        }
        // What a faulty unit has lost comes as zeroes, and is told as what is not the model's.
        if constexpr (requires { Unit::outputs_of(inputs); })
            outputs_.resize(Unit::outputs_of(inputs));
        return outputs_;
    }

private:
    static constexpr unsigned MostQuietCycles = 64; // more than any unit's latency

    bool is_done(std::span<const Input> inputs, std::size_t taken, unsigned quiet) const {
        if (taken < inputs.size()) return false;
        if constexpr (requires { Unit::outputs_of(inputs); }) {
            return outputs_.size() == Unit::outputs_of(inputs) || quiet == MostQuietCycles;
        } else {
            return quiet == Unit::QuietCycles;
        }
    }

    void receive() {
        Bits bits = with_tag<Output>(sample(dut_->out_data_o, bits_of<Output>()));
        const std::optional<PlantedFault>& fault = loop_log().fault;
        if (fault && fault->unit == Unit::Name && loop_log().faulty_items++ >= fault->from)
            flip(bits, fault->field);
        outputs_.push_back(from_bits<Output>(bits));
    }
    // Outside, tags are 0: one that comes out wrong is left at 1.
    template <class Packed>
    Bits with_tag(Bits bits) const {
        unsigned at = bits.count;
        const Packed packed{};
        const auto turn = [&](FieldName name, const auto&, unsigned width = 32) {
            at -= width;
            if (name.text() == "tag" || name.text() == "header.tag")
                put(bits, at, 1, take(bits, at, 1) ^ bank_);
        };
        if (bank_ != 0) Packed::visit(packed, turn);
        return bits;
    }
    static Bits opposite(Bits bits) {
        for (unsigned at = 0; at < bits.count; ++at)
            put(bits, at, 1, take(bits, at, 1) ^ 1);
        return bits;
    }
    static void flip(Bits& bits, const std::string& field) {
        unsigned at = bits.count;
        const Output output{};
        const auto flip_lowest = [&](FieldName name, const auto&, unsigned width = 32) {
            at -= width;
            if (name.text() == field) put(bits, at, 1, take(bits, at, 1) ^ 1);
        };
        Output::visit(output, flip_lowest);
    }

    void clock() {
        dut_->clk_i = 1;
        dut_->eval();
        waves_.clocked();
        dut_->clk_i = 0;
    }

    std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
    std::unique_ptr<typename Unit::Dut> dut_ = std::make_unique<typename Unit::Dut>(context_.get());
    Waves waves_{*dut_, loop_log().waves, Unit::Name, loop_log().wave_cycles};
    std::vector<Output> outputs_;
    unsigned bank_ = 0;
};

// An output for each input.
template <class Input>
struct OneToOne {
    static std::size_t outputs_of(std::span<const Input> inputs) { return inputs.size(); }
};

// The one unit of its kind.
template <class Unit>
UnitDriver<Unit>& unit() {
    static UnitDriver<Unit> driver;
    return driver;
}

} // namespace ffgpu::rtl
