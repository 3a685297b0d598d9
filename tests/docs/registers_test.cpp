// The checked-in register page and SystemVerilog package say what the list of registers says.

#include "model/device/registers.h"
#include "tests/docs/register_list.h"
#include "tests/docs/text_file.h"

#include <catch2/catch.hpp>

namespace ffgpu::docs {

TEST_CASE("docs/registers.md is what the list of registers prints") {
    INFO("cmake --build build --target registers_page writes it anew");
    CHECK(read_source("docs/registers.md") == registers_page(list_registers()));
}

TEST_CASE("rtl/ffgpu_registers_pkg.sv is what the list of registers prints") {
    INFO("cmake --build build --target registers_page writes it anew");
    CHECK(read_source("rtl/ffgpu_registers_pkg.sv") == registers_package(list_registers()));
}

TEST_CASE("every register has its address, and no two fields share a bit") {
    unsigned address = 0;
    for (const RegisterEntry& reg : list_registers()) {
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
