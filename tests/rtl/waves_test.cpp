// Waves of a unit, read back: signals under their names and those of their fields, with the values
// that were driven.

#include "Valpha_test.h"
#include "rtl/bundles/ports.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/waves.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fstapi.h>

namespace ffgpu::rtl {
namespace {

constexpr unsigned Quads = 20;

std::uint16_t x_of(unsigned quad) {
    return static_cast<std::uint16_t>(2 * (37 * quad % 4096));
}

void draw_quads(const std::filesystem::path& folder, const WaveCycles& cycles = {}) {
    const auto context = std::make_unique<VerilatedContext>();
    const auto dut = std::make_unique<Valpha_test>(context.get());
    Waves waves(*dut, folder, "alpha_test", cycles);
    dut->out_ready_i = 1;
    dut->in_valid_i = 1;
    dut->rst_ni = 1;
    for (unsigned quad = 0; quad < Quads; ++quad) {
        drive(dut->in_data_i, to_bits(Quad{.x = x_of(quad), .live = 15}));
        dut->eval();
        waves.settled();
        dut->clk_i = 1;
        dut->eval();
        waves.clocked();
        dut->clk_i = 0;
    }
}

class WaveFile {
public:
    explicit WaveFile(const std::filesystem::path& path)
        : reader_(fstReaderOpen(path.c_str())) {
        REQUIRE(reader_);
        while (const fstHier* const entry = fstReaderIterateHier(reader_)) {
            if (entry->htyp == FST_HT_SCOPE)
                fstReaderPushScope(reader_, entry->u.scope.name, nullptr);
            if (entry->htyp == FST_HT_UPSCOPE) fstReaderPopScope(reader_);
            if (entry->htyp == FST_HT_VAR) add(entry->u.var);
        }
    }
    ~WaveFile() { fstReaderClose(reader_); }
    WaveFile(const WaveFile&) = delete;
    WaveFile& operator=(const WaveFile&) = delete;

    bool has(const std::string& signal) const { return signals_.contains(signal); }

    // By the time from which on the signal has it.
    std::map<std::uint64_t, std::uint64_t> values(const std::string& signal) {
        std::map<std::uint64_t, std::uint64_t> values;
        fstReaderClrFacProcessMaskAll(reader_);
        fstReaderSetFacProcessMask(reader_, signals_.at(signal));
        fstReaderIterBlocks(
            reader_,
            [](void* into, uint64_t time, fstHandle, const unsigned char* text) {
                const std::string bits(reinterpret_cast<const char*>(text));
                (*static_cast<decltype(values)*>(into))[time] = std::stoull(bits, nullptr, 2);
            },
            &values,
            nullptr);
        return values;
    }

private:
    void add(const decltype(fstHier::u.var)& variable) {
        const std::string name(variable.name);
        signals_.emplace(std::string(fstReaderGetCurrentFlatScope(reader_)) + '.' +
                             name.substr(0, name.find(' ')),
                         variable.handle);
    }

    void* reader_;
    std::map<std::string, fstHandle> signals_;
};

TEST_CASE("Waves have each field of a structure under its name, with its values") {
    const std::filesystem::path folder =
        std::filesystem::path("rtl_waves") / "of alpha_test"; // It is made.
    std::filesystem::remove_all(folder);
    draw_quads(folder);
    WaveFile file(folder / "alpha_test.fst");
    for (const char* const signal : {"TOP.alpha_test.clk_i",
                                     "TOP.alpha_test.in_valid_i",
                                     "TOP.alpha_test.in_data_i.live",
                                     "TOP.alpha_test.out_data_o.color"})
        CHECK(file.has(signal));
    const auto values = file.values("TOP.alpha_test.in_data_i.x");
    for (unsigned quad = 0; quad < Quads; ++quad) {
        INFO("quad " << quad);
        REQUIRE(values.contains(2 * quad));
        CHECK(values.at(2 * quad) == x_of(quad));
    }
    CHECK(values.size() == Quads);
}

TEST_CASE("Waves of some cycles have no others") {
    const std::filesystem::path folder = std::filesystem::path("rtl_waves") / "some cycles";
    std::filesystem::remove_all(folder);
    draw_quads(folder, {.first = 7, .last = 11});
    const auto values = WaveFile(folder / "alpha_test.fst").values("TOP.alpha_test.in_data_i.x");
    std::map<std::uint64_t, std::uint64_t> expected;
    for (unsigned quad = 7; quad <= 11; ++quad)
        expected[2 * quad] = x_of(quad);
    CHECK(values == expected);
}

TEST_CASE("No folder, no waves") {
    draw_quads({});
    CHECK_FALSE(std::filesystem::exists("alpha_test.fst"));
}

} // namespace
} // namespace ffgpu::rtl
