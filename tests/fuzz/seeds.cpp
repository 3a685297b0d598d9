// Makes an input of a corpus of a sound file: fuzz_seeds trace|capture|work_file FILE INPUT

#include "model/base/input_error.h"
#include "tests/fuzz/packing.h"

#include <cstdio>
#include <fstream>
#include <string_view>

int main(int count, char** arguments) {
    using namespace ffgpu::fuzz;
    const std::string_view kind = count == 4 ? arguments[1] : "";
    const auto unpack = kind == "trace"       ? unpack_trace
                        : kind == "capture"   ? unpack_capture
                        : kind == "work_file" ? unpack_work_file
                                              : nullptr;
    if (!unpack) {
        std::fprintf(stderr, "usage: %s trace|capture|work_file FILE INPUT\n", arguments[0]);
        return 2;
    }
    try {
        const auto input = unpack(arguments[2]);
        std::ofstream(arguments[3], std::ios::binary)
            .write(reinterpret_cast<const char*>(input.data()),
                   static_cast<std::streamsize>(input.size()));
    } catch (const ffgpu::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
