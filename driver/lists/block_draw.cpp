#include "driver/lists/block_draw.h"

#include "driver/objects/shared_objects.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/immediate_vertices.h"
#include "driver/vertex/vertex_context.h"

#include <algorithm>

namespace ffgpu::gl {

namespace {

// The words with the values that the first vertices take from the current state.
std::vector<float> complete_words(const VertexBlock& block, const CurrentState& current) {
    std::vector<float> words = block.words;
    const std::size_t stride = block.format.stride;
    const std::size_t vertices = words.size() / stride;
    for (std::size_t a = 1; a < Attributes; ++a) {
        const VertexElement element = block.format.elements[a];
        const Vec4& value = current.of(static_cast<Attribute>(a));
        const std::size_t inheriting = std::min<std::size_t>(block.inherited[a], vertices);
        for (std::size_t i = 0; i < inheriting; ++i)
            std::copy_n(value.begin(),
                        element.components,
                        words.begin() + static_cast<std::ptrdiff_t>(i * stride + element.offset));
    }
    return words;
}

bool make_resident(VertexContext& context, VertexBlock& block) {
    if (block.memory) return true;
    const VertexRun run = block.run();
    const auto words = std::as_bytes(run.words);
    const std::size_t count = block.indices.size();
    block.memory = DeviceBlock::allocate(
        context.shared().memory, count == 0 ? words.size() : DrawPath::indexed_bytes(run, count));
    if (!block.memory) return false;
    if (count == 0)
        context.device().write_memory(block.memory.address(), words);
    else
        context.draw_path().write_indexed(run, block.indices, block.memory.address());
    return true;
}

// Call by call: within a glBegin outside of the list (an error, but for its vertices), or if the
// block does not fit into the device's memory.
void replay(VertexContext& context, const VertexBlock& block) {
    const std::vector<float> words = complete_words(block, context.state.current);
    VertexAssembler& to = context.immediate();
    const auto value = [&](std::size_t vertex, VertexElement element) {
        Vec4 result = MissingComponents;
        const float* const from = words.data() + vertex * block.format.stride + element.offset;
        std::copy_n(from, element.components, result.begin());
        return result;
    };
    for (const RunPrimitive& primitive : block.primitives) {
        to.begin(static_cast<GLenum>(primitive.type));
        for (std::size_t at = primitive.first; at < primitive.first + primitive.count; ++at) {
            const std::size_t i = block.indices.empty() ? at : block.indices[at];
            for (std::size_t a = 1; a < Attributes; ++a) {
                const VertexElement element = block.format.elements[a];
                if (element.components != 0)
                    to.set(static_cast<Attribute>(a), element.components, value(i, element));
            }
            to.vertex(block.format.elements[0].components, value(i, block.format.elements[0]));
        }
        to.end();
    }
    for (std::size_t a = 1; a < Attributes; ++a) {
        const VertexElement element = block.format.elements[a];
        if (block.sets >> a & 1)
            to.set(static_cast<Attribute>(a), element.components, block.last[a]);
    }
}

} // namespace

void execute_block(VertexContext& context, VertexBlock& block) {
    if (block.is_array_draw && context.fails_inside_begin()) return;
    if (block.primitives.empty()) return;
    if (context.vertex_phase == VertexPhase::Inside) return replay(context, block);
    context.flush_vertices();

    CurrentState& current = context.state.current;
    DrawPath& path = context.draw_path();
    if (block.inherits) {
        if (block.words.size() > path.max_words()) return replay(context, block);
        const std::vector<float> words = complete_words(block, current);
        path.draw({block.format, words, block.primitives});
    } else {
        if (!make_resident(context, block)) return replay(context, block);
        if (block.indices.empty())
            path.draw_resident(block.run(), block.memory.address());
        else
            path.draw_resident_indexed(block.run(), block.memory.address());
    }
    if (block.sets == 0) return;
    for (std::size_t a = 1; a < Attributes; ++a) {
        if (block.sets >> a & 1) current.of(static_cast<Attribute>(a)) = block.last[a];
    }
}

} // namespace ffgpu::gl
