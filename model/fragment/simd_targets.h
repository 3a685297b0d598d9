// Which instruction sets the fragment stages are compiled for; included before Highway.
//
// Vectors are 32 lanes of 16 bits at most (lanes-inl.h). The floor of x86-64 is SSE4 (every
// processor since 2009): Highway's own floor there has vectors of one lane, which cannot be halved
// and combined.

#pragma once

#if defined(__x86_64__)
#define HWY_BASELINE_TARGETS HWY_SSE4
#endif
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
