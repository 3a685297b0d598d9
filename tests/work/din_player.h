// Dinero's files played into a plain cache of lines of 64 bytes, as its own readers would.

#pragma once

#include "tests/work/plain_cache.h"

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace ffgpu::test {

// As Dinero III reads it: 4 empties the cache.
inline void play_din(const std::vector<std::string>& lines, PlainCache& cache) {
    for (const std::string& line : lines) {
        std::istringstream words(line);
        int label = -1;
        std::uint64_t address = 0;
        words >> label >> std::hex >> address;
        if (label == 4)
            cache.flush();
        else
            cache.access(address / 64, label == 1);
    }
}

// As Dinero IV does: c copies back, v forgets without; the whole cache where there is no size.
inline void play_xdin(const std::vector<std::string>& lines, PlainCache& cache) {
    bool copied = false; // by the record before, which goes with a v
    for (const std::string& line : lines) {
        std::istringstream words(line);
        char label = 0;
        std::uint64_t address = 0, size = 0;
        words >> label >> std::hex >> address >> size;
        if (label == 'r' || label == 'w') cache.access(address / 64, label == 'w');
        if (label == 'v' && size == 0) cache.flush();
        if (label == 'v' && size > 0) cache.overwrite(address / 64, !copied);
        copied = label == 'c';
    }
}

} // namespace ffgpu::test
