// LineStore: the memory behind a cache where a line does not lie there as it is: what fetching and
// writing a line moves is its answer, not the line's bytes.

#pragma once

#include "model/work/line_mask.h"

#include <cstdint>

namespace ffgpu::timing {

// A line on its way to memory.
struct LineWrite {
    std::uint64_t number = 0;
    std::uint32_t bytes = 0;      // moved
    std::uint32_t read_bytes = 0; // read before, to be completed
};

// A line that leaves its cache: which of its bytes are there, and which memory does not have.
struct LeavingLine {
    std::uint64_t number = 0;
    work::LineMask valid = 0;
    work::LineMask dirty = 0;
};

class LineStore {
public:
    virtual ~LineStore() = default;

    // Bytes that reading the line would move; none: it need not be read. No effect.
    virtual std::uint32_t stored_bytes(std::uint64_t number) const = 0;
    // It is read; `dirty`: of the line in the cache, if part of it is there.
    virtual void fetched(std::uint64_t number, work::LineMask dirty) = 0;
    // It leaves, with dirty bytes.
    virtual LineWrite write_back(const LeavingLine& line) = 0;
};

} // namespace ffgpu::timing
