// A GPU that all inputs of a target are played on, reset between them: to make one takes longer
// than most inputs.

#pragma once

#include "model/gpu/functional_gpu.h"

#include <cstdint>

namespace ffgpu::fuzz {

template <std::uint64_t MemoryMiB>
class KeptGpu {
public:
    KeptGpu() { gpu.reset(); }
    // What waits to be drawn is this input's.
    ~KeptGpu() { gpu.finish(); }
    KeptGpu(const KeptGpu&) = delete;
    KeptGpu& operator=(const KeptGpu&) = delete;

    static inline FunctionalGpu gpu{{.memory_bytes = MemoryMiB << 20}};
};

} // namespace ffgpu::fuzz
