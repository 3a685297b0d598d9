#include "tools/rtl/pipe_records.h"

#include "model/base/float_environment.h"

namespace ffgpu::tools {

void PipeRecords::make(const Registers& registers,
                       std::uint32_t number,
                       const DrawCommand& command) {
    const FloatEnvironment environment;
    context_ = compile_draw_context(
        std::make_shared<const Registers>(registers), number, pixel_contexts_, nullptr);
    arena_.clear();
    places_.clear();
    last_key_ = next_piece_ = 0;
    geometry_.draw(context_->state, command, *this);
}

void PipeRecords::primitives(std::span<const Primitive> batch) {
    for (const Primitive& primitive : batch) {
        if (primitive.key != last_key_) next_piece_ = 0;
        last_key_ = primitive.key;
        const std::size_t at = arena_.size();
        arena_.resize(at + MostBlocks);
        auto& record = *::new (&arena_[at]) SetupRecord;
        record.piece = next_piece_++;
        const bool covers = set_up(context_->setup, primitive, record) && !record.covers_nothing;
        const std::size_t blocks = (record.bytes() + sizeof(Block) - 1) / sizeof(Block);
        arena_.resize(covers ? at + blocks : at);
        if (covers) places_.push_back(at);
    }
}

} // namespace ffgpu::tools
