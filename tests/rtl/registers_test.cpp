// The struct that a decode function of rtl/ffgpu_registers_pkg.sv makes of a register's or a
// command's words has in each field, by its name, what the model unpacks.

#include "Vregister_fields.h"
#include "model/device/commands.h"
#include "model/device/description.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <verilated.h>

namespace ffgpu {
namespace {

// The module's numbers: registers first, then the commands that have a payload.
unsigned number_of(const std::string& name) {
    const Description contract = describe_contract();
    std::vector<std::string> names;
    for (const PackedEntry& reg : contract.registers)
        names.push_back(reg.name);
    for (const PackedEntry& command : contract.commands)
        if (command.words > 0) names.push_back(command.name);
    const auto found = std::find(names.begin(), names.end(), name);
    REQUIRE(found != names.end());
    return static_cast<unsigned>(found - names.begin());
}

template <class Packed>
std::vector<std::uint32_t> fields_of(const std::vector<std::uint32_t>& words) {
    const auto unpacked = unpack<Packed>(words);
    std::vector<std::uint32_t> fields;
    Packed::visit(unpacked, [&](FieldName, const auto& field, unsigned width = 32) {
        fields.push_back(field_bits(field) & (~std::uint32_t{0} >> (32 - width)));
    });
    return fields;
}

class Bench {
public:
    template <class Packed>
    void compare(unsigned rounds) {
        INFO(Packed::Name);
        const unsigned number = number_of(Packed::Name);
        std::vector<std::uint32_t> words(WordCount<Packed>);
        unsigned wrong = 0;
        for (unsigned round = 0; round < rounds; ++round) {
            for (std::uint32_t& word : words)
                word = static_cast<std::uint32_t>(random_());
            for (unsigned i = 0; i < 64; ++i) // What is not the register's is noise.
                dut_.words_i[i] =
                    i < words.size() ? words[i] : static_cast<std::uint32_t>(random_());
            const std::vector<std::uint32_t> expected = fields_of<Packed>(words);
            for (unsigned field = 0; field < expected.size(); ++field) {
                dut_.packed_i = static_cast<std::uint16_t>(number);
                dut_.field_i = static_cast<std::uint16_t>(field);
                dut_.eval();
                wrong += dut_.value_o != expected[field];
                ++compared;
            }
        }
        CHECK(wrong == 0);
    }

    std::uint64_t compared = 0;

private:
    std::mt19937 random_{7};
    Vregister_fields dut_;
};

TEST_CASE("a decoded register has in each field what the model unpacks") {
    Bench bench;
    std::string last;
    const Registers registers;
    Registers::visit(registers, [&](const auto& reg) {
        using Register = std::remove_cvref_t<decltype(reg)>;
        if (last != Register::Name) bench.compare<Register>(200);
        last = Register::Name;
    });
    CHECK(bench.compared > 50000);
}

TEST_CASE("a decoded command has in each field what the model unpacks") {
    Bench bench;
    visit_commands([&](const auto& command) {
        using Command = std::remove_cvref_t<decltype(command)>;
        if constexpr (WordCount<Command> != 0) bench.compare<Command>(200);
    });
    CHECK(bench.compared > 10000);
}

} // namespace
} // namespace ffgpu
