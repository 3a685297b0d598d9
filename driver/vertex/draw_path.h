// DrawPath: the one way of vertices to the device. It puts them into device memory, sets the
// registers that describe them, and submits the draws; in selection and feedback mode it hands the
// draws' results to RenderModes instead.

#pragma once

#include "driver/vertex/vertex_ring.h"
#include "driver/vertex/vertex_run.h"
#include "model/device/commands.h"

#include <span>
#include <vector>

namespace ffgpu::gl {

class VertexContext;

class DrawPath {
public:
    explicit DrawPath(VertexContext& context);

    // The most words of a run, and of its indices, that draw() takes.
    std::size_t max_words();

    // A place where a run of so many words may be made; valid until the next call.
    std::span<float> scratch(std::size_t words);
    std::vector<std::uint32_t>& index_scratch() { return index_scratch_; }

    // Draws a run that lies in host memory.
    void draw(const VertexRun& run);

    // The same with indices into the words (each in range), for the run's only primitive.
    void draw_indexed(const VertexRun& run, std::span<const std::uint32_t> indices);

    // A run whose words are in device memory already.
    void draw_resident(const VertexRun& run, DeviceAddress address);

    // The words of a run and `count` indices into it, in one place.
    static std::size_t indexed_bytes(const VertexRun& run, std::size_t count);
    void write_indexed(const VertexRun& run,
                       std::span<const std::uint32_t> indices,
                       DeviceAddress address);
    void draw_resident_indexed(const VertexRun& run, DeviceAddress address);

private:
    bool prepare(const VertexFormat& format);
    void submit();

    VertexContext& context_;
    VertexRing ring_;
    std::vector<float> scratch_;
    std::vector<std::uint32_t> index_scratch_;
    CommandStream commands_;
    std::vector<DrawCommand> draws_;
    std::vector<std::uint16_t> short_indices_;
};

} // namespace ffgpu::gl
