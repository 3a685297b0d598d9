// The host's half of a draw by the fragment pipe in RTL: geometry and set-up. What comes of them
// are the records that the pipe draws.

#pragma once

#include "model/geometry/geometry_unit.h"
#include "model/gpu/draw_context.h"
#include "model/gpu/functional_gpu.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace ffgpu::tools {

class PipeRecords final : private PrimitiveSink {
public:
    explicit PipeRecords(std::span<std::byte> memory)
        : pixel_contexts_(memory, *FastStages.fragment)
        , geometry_(memory) {}

    // Of a draw under the registers.
    void make(const Registers& registers, std::uint32_t number, const DrawCommand& command);

    const DrawContext& context() const { return *context_; }
    template <class Visit>
    void for_each(Visit&& visit) const {
        for (const std::size_t at : places_)
            visit(*reinterpret_cast<const SetupRecord*>(&arena_[at]));
    }

private:
    struct alignas(SetupRecord) Block {
        std::byte bytes[alignof(SetupRecord)];
    };
    static constexpr std::size_t MostBlocks = MaxSetupRecordBytes / sizeof(Block) + 1;

    void primitives(std::span<const Primitive> batch) override;

    PixelContexts pixel_contexts_;
    GeometryUnit geometry_;
    std::shared_ptr<const DrawContext> context_;
    std::vector<Block> arena_; // records one behind the other, each from a block on
    std::vector<std::size_t> places_;
    std::uint32_t last_key_ = 0, next_piece_ = 0;
};

} // namespace ffgpu::tools
