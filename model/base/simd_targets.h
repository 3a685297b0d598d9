// Which instruction sets Highway compiles for here; included before it. On x86-64: SSE4 (every
// processor since 2009; Highway's own floor has vectors of one lane), AVX2 and AVX-512.

#pragma once

#if defined(__x86_64__)
#define HWY_BASELINE_TARGETS HWY_SSE4
#endif
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
