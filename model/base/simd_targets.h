// Which instruction sets the vector stages are compiled for; included before Highway. On x86-64:
// SSE4 (every processor since 2009; Highway's own floor has vectors of one lane, which cannot be
// halved and combined, and which quads of four do not fit), AVX2 and AVX-512. Vectors of the
// fragment stages are 32 lanes of 16 bits at most.

#pragma once

#if defined(__x86_64__)
#define HWY_BASELINE_TARGETS HWY_SSE4
#endif
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
