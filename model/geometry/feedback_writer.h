// FeedbackWriter: primitives as records in device memory, as DrawCommand describes them.

#pragma once

#include "model/device/commands.h"
#include "model/geometry/primitive_output.h"
#include "model/packets/interpolants.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

class FeedbackWriter final : public FeedbackOutput {
public:
    // What a feedback record's vertices carry, whatever the draw's own layout is.
    static InterpolantLayout layout();

    // buffer: at least one word.
    explicit FeedbackWriter(std::span<std::byte> buffer)
        : buffer_(buffer) {}

    void point(const WindowVertex& vertex) override;
    void line(const WindowVertex& a, const WindowVertex& b, bool reset) override;
    void polygon(std::span<const WindowVertex* const> corners) override;

    // Writes the buffer's first word: the bytes after it, or that they did not fit.
    void finish();

private:
    void record(FeedbackKind kind, std::span<const WindowVertex* const> vertices);
    void put(std::uint32_t word);
    void put(float value);

    std::span<std::byte> buffer_;
    std::size_t used_ = sizeof(std::uint32_t);
    bool overflow_ = false;
};

} // namespace ffgpu
