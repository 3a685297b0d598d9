// The checked-in register page and SystemVerilog package say what the list of registers says.

#include "model/device/registers.h"
#include "tests/docs/register_pages.h"
#include "tests/docs/text_file.h"

#include <catch2/catch.hpp>

namespace ffgpu::docs {

TEST_CASE("docs/registers.md is what the list of registers prints") {
    INFO("cmake --build build --target registers_page writes it anew");
    CHECK(read_source("docs/registers.md") == registers_page(describe_contract()));
}

TEST_CASE("rtl/ffgpu_registers_pkg.sv is what the list of registers prints") {
    INFO("cmake --build build --target registers_page writes it anew");
    CHECK(read_source("rtl/ffgpu_registers_pkg.sv") == registers_package(describe_contract()));
}

TEST_CASE("tests/rtl/register_fields.sv is what the list of registers prints") {
    INFO("cmake --build build --target registers_page writes it anew");
    CHECK(read_source("tests/rtl/register_fields.sv") ==
          register_fields_module(describe_contract()));
}

TEST_CASE("every register has its address, and no two fields share a bit") {
    unsigned address = 0;
    const Description contract = describe_contract();
    for (const PackedEntry& reg : contract.registers) {
        INFO(reg.name);
        CHECK(reg.address == address);
        address += reg.count;
        std::vector<std::uint32_t> taken(reg.words);
        for (const FieldEntry& field : reg.fields) {
            INFO(field.name);
            const std::uint32_t mask = ~std::uint32_t{0} >> (32 - field.width) << field.lsb;
            for (unsigned i = 0; i < field.elements(); ++i) {
                REQUIRE(field.word + i < reg.words);
                CHECK((taken[field.word + i] & mask) == 0);
                taken[field.word + i] |= mask;
            }
        }
    }
    CHECK(address == RegisterCount);
}

} // namespace ffgpu::docs
