// Instruction sets the texture unit's vector stages are compiled for: SSE4, AVX2, AVX3 on x86-64,
// and Highway's plain fallback. SSSE3 would only lengthen the build: processors that have it and
// not SSE4 are gone. Included before Highway.

#pragma once

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
