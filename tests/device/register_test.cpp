// Registers survive packing, and the command stream carries exactly what changed.

#include "model/device/commands.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

TEST_CASE("every register comes back from its words, at reset") {
    const Registers registers;
    Registers::visit(registers, [](const auto& reg) {
        using Register = std::remove_cvref_t<decltype(reg)>;
        std::vector<std::uint32_t> words(WordCount<Register>);
        pack(reg, words);
        INFO(Register::Name);
        CHECK(unpack<Register>(words) == reg);
    });
}

TEST_CASE("signed fields keep their sign") {
    Sampler sampler;
    sampler.bias = -5;
    sampler.min_lod = -4096;
    std::vector<std::uint32_t> words(WordCount<Sampler>);
    pack(sampler, words);
    CHECK(unpack<Sampler>(words) == sampler);
}

TEST_CASE("only registers that changed are written") {
    Registers from, to;
    to.fog.density = 3;
    to.samplers[2].bias = -5;
    CommandStream stream;
    write_changes(from, to, stream);
    CHECK(stream.words.size() == 2 + WordCount<Sampler> + 2 + WordCount<Fog>);
    stream.clear();
    write_changes(to, to, stream);
    CHECK(stream.empty());
}

} // namespace
} // namespace ffgpu
