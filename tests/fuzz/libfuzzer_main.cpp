// The entrance that clang's libFuzzer calls.

#include "tests/fuzz/fuzz_target.h"

#include <cstddef>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    ffgpu::fuzz::run({bytes, count});
    return 0;
}
