// A GPU that all inputs of a target are played on, reset between them: to make one takes longer
// than most inputs.

#pragma once

#include "model/gpu/functional_gpu.h"

#include <cstdint>

namespace ffgpu::fuzz {

template <std::uint64_t MemoryMiB>
class KeptGpu {
public:
    KeptGpu() { gpu_.reset(); }
    // What waits to be drawn is this input's.
    ~KeptGpu() { gpu_.finish(); }
    KeptGpu(const KeptGpu&) = delete;
    KeptGpu& operator=(const KeptGpu&) = delete;

    static FunctionalGpu& gpu() { return gpu_; }

private:
    static inline FunctionalGpu gpu_{{.memory_bytes = MemoryMiB << 20}};
};

} // namespace ffgpu::fuzz
