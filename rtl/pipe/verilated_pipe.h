// The pipe's module with its clock, and memory at its ports.

#pragma once

#include "Vfragment_pipe.h"
#include "rtl/bundles/ports.h"
#include "rtl/bundles/waves.h"
#include "rtl/pipe/memory_ports.h"
#include "rtl/pipe/pipe.h"

#include <memory>

namespace ffgpu::rtl {

class VerilatedPipe final : public Pipe {
public:
    explicit VerilatedPipe(const PipeOptions& options);

    void set_memory(std::span<std::byte> memory) override { memory_.set(memory); }
    void forget_textures() override;
    void begin_draw(const DrawContext& context, std::uint32_t number) override;
    void add(const SetupRecord& record) override;
    bool finish() override;
    void reset() override;
    std::uint64_t cycles() const override { return cycle_; }
    PipeActivity activity() const override { return activity_; }
    double seconds() const override { return seconds_; }

private:
    void cycle();
    template <class Done>
    void clock_until(const Done& done);
    void drive_memory();
    void take_requests();
    void count_activity();
    template <class Valid>
    void take_back(TargetPort& port, Valid& valid);
    template <class Valid, class Data>
    void offer(TargetPort& port, Valid& valid, Data& data);
    TargetPort::Words read_words(std::uint64_t request);
    void store(const VlWide<7>& store, bool is_color);
    std::uint64_t due() {
        return cycle_ + options_.latency + (options_.jitters ? stalls_.below(2) : 0);
    }

    PipeOptions options_;
    Stalls stalls_;
    PipeMemory memory_;
    TexelPort texels_;
    TargetPort depths_, colors_;
    std::unique_ptr<VerilatedContext> context_;
    std::unique_ptr<Vfragment_pipe> dut_ = std::make_unique<Vfragment_pipe>(context_.get());
    Waves waves_;
    InterpolantLayout layout_; // of the draw that is added to
    std::uint32_t draw_ = 0;
    bool tag_ = false, moved_ = false, stands_ = false;
    bool plane_taken_ = false, record_taken_ = false; // in the last cycle
    std::uint64_t quiet_ = 0;
    std::uint64_t cycle_ = 0, color_stores_ = 0;
    PipeActivity activity_;
    double seconds_ = 0, began_ = 0;
};

} // namespace ffgpu::rtl
