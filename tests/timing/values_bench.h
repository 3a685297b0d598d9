// A machine that follows values, fed with what the functional GPU draws, and beside it somebody who
// follows them in the order of the commands, without a clock.

#pragma once

#include "model/timing/machine.h"
#include "model/work/command_assembler.h"
#include "tests/timing/machine_figures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <memory>

namespace ffgpu::timing {

class ValuesBench final : public work::CommandSink {
public:
    explicit ValuesBench(const TimingConfig& config, const Evaluation& evaluation = {})
        : machine_(make(config, evaluation))
        , machine_order_(config.work(), *machine_)
        , contents{work::SurfaceContents(config.depth_cache.line_bytes),
                   work::SurfaceContents(config.color_cache.line_bytes)}
        , follower_{*this}
        , order_(config.work(), follower_) {
        machine_->on_retire = [this](const QuadRetired& quad) {
            written += static_cast<unsigned>(std::popcount(quad.written));
        };
    }
    ~ValuesBench() override {
        const SimulationContext::Scope scope(context_);
        machine_.reset();
    }

    void command(std::shared_ptr<const work::WholeCommand> command) override {
        machine_order_.command(command);
        order_.command(command);
    }
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        machine_order_.content(content);
        order_.content(content);
    }
    void host_transfer(const HostTransfer& transfer) override {
        machine_order_.host_transfer(transfer);
        order_.host_transfer(transfer);
    }
    void end_frame(std::uint32_t frame) override {
        machine_order_.end_frame(frame);
        order_.end_frame(frame);
    }

    Figures figures() {
        Figures all;
        for (const StatisticsGroup* group : machine_->statistics())
            for (const Counter& counter : group->counters())
                all[std::string(counter.name())] = counter.value();
        return all;
    }
    // Lines of which the machine and the follower know different bytes.
    int differing_lines() const {
        int differ = 0;
        for (const auto& told : places_) {
            const work::SurfaceContents& here = contents[told.second.depth ? 0 : 1];
            const BlockStates* const there =
                told.second.depth ? machine_->blocks.depth.get() : machine_->blocks.color.get();
            if (!there) continue;
            const std::uint32_t bytes = told.second.depth ? machine_->config.depth_cache.line_bytes
                                                          : machine_->config.color_cache.line_bytes;
            const work::PlacedLevel& place = told.second.place;
            for (std::uint64_t at = 0; at < place.layer_bytes; at += bytes) {
                const auto a = here.line((place.base + at) / bytes);
                const auto b = there->contents().line((place.base + at) / bytes);
                differ += !std::equal(a.begin(), a.end(), b.begin(), b.end());
            }
        }
        return differ;
    }

    std::uint64_t written = 0; // fragments

private:
    struct Follower final : work::MachineSink {
        explicit Follower(ValuesBench& owner)
            : bench(owner) {}
        void scene(work::PreparedScene&& scene) override;
        void transfer(work::PreparedTransfer&& transfer) override {
            for (const work::SurfaceFill& fill : transfer.fills)
                for (work::SurfaceContents& filled : bench.contents)
                    filled.fill(fill);
        }
        void content(work::PreparedContent&& told) override {
            bench.contents[told.depth ? 0 : 1].set(told.place, *told.content, [](std::uint64_t) {});
            bench.places_[told.place.base] = told;
        }
        void host_transfer(const HostTransfer&) override {}
        void end_frame(std::uint32_t) override {}
        ValuesBench& bench;
    };

    std::unique_ptr<Machine> make(const TimingConfig& config, const Evaluation& evaluation) {
        const SimulationContext::Scope scope(context_);
        return std::make_unique<Machine>(context_, config, evaluation, MakeMemory{});
    }

    SimulationContext context_;
    std::unique_ptr<Machine> machine_;
    work::MachineOrder machine_order_;

public:
    std::array<work::SurfaceContents, 2> contents; // depth, colour

private:
    std::map<std::uint64_t, work::PreparedContent> places_;
    Follower follower_;
    work::MachineOrder order_;
};

inline void ValuesBench::Follower::scene(work::PreparedScene&& scene) {
    for (const PreparedQuad& quad : scene.quads) {
        const PreparedDraw& draw = scene.draws[quad.draw];
        const QuadValues values = scene.values_of(draw, quad);
        const auto follow = [&](work::SurfaceContents& to,
                                const work::PlacedLevel& place,
                                const SampleWords& words,
                                std::uint32_t bytes) {
            std::uint64_t last = ~std::uint64_t{0};
            for (unsigned lane = 0; lane < 4; ++lane)
                for (unsigned sample = 0; sample < place.samples; ++sample) {
                    const std::uint64_t line =
                        (place.address(quad.x + (lane & 1u), quad.y + (lane >> 1), 0) +
                         sample * place.layout.element_bytes / place.samples) /
                        bytes;
                    if (line != last) to.write(place, quad, words, line);
                    last = line;
                }
        };
        const TimingConfig& config = bench.machine_->config;
        if (draw.value_kinds.depth_words)
            follow(bench.contents[0],
                   draw.depth_place,
                   values.depth_words,
                   config.depth_cache.line_bytes);
        for (std::size_t i = 0; i < draw.color_places.size(); ++i)
            follow(bench.contents[1],
                   draw.color_places[i],
                   values.colors[draw.color_targets[i]],
                   config.color_cache.line_bytes);
    }
}

} // namespace ffgpu::timing
