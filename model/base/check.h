// check(): the one assertion, on in every build: a wrong frame costs more than a compare.
// It is for the emulator's own mistakes. Bad input has its own channels (see docs/architecture.md).

#pragma once

#include <cstdio>
#include <cstdlib>

namespace ffgpu {

inline void check(bool condition,
                  const char* message,
                  const char* file = __builtin_FILE(),
                  int line = __builtin_LINE()) {
    if (condition) [[likely]]
        return;
    std::fprintf(stderr, "%s:%d: internal error: %s\n", file, line, message);
    std::abort();
}

} // namespace ffgpu
