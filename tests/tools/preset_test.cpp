// Presets: every one is a machine that can be built, from one list, with a source for each number.

#include "model/base/input_error.h"
#include "model/timing/gpu_timing.h"
#include "model/timing/presets.h"
#include "tests/docs/text_file.h"
#include "tools/config/config_file.h"
#include "tools/config/preset.h"

#include <algorithm>
#include <set>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

Configuration configured(const std::string& config) {
    Configuration configuration;
    read_config_file(config, configuration);
    return configuration;
}

TEST_CASE("Every preset is a machine that can be built, and another than the default") {
    std::set<std::string> machines{to_toml({})};
    for (const timing::Preset& preset : timing::presets()) {
        INFO(preset.name);
        const Configuration configuration = configured("preset:" + std::string(preset.name));
        timing::GpuTiming machine(configuration.timing);
        machine.end_frame(0);
        CHECK(machines.insert(to_toml(configuration)).second);
    }
}

TEST_CASE("Every number of a preset has a source in the list, or is said to be assumed") {
    std::set<std::string_view> used;
    for (const timing::Preset& preset : timing::presets())
        for (const timing::PresetSetting& setting : preset.settings) {
            INFO(preset.name << ": " << setting.parameter);
            CHECK(!setting.reason.empty());
            if (setting.source == "assumed") continue;
            used.insert(setting.source);
            CHECK(std::ranges::count(
                      timing::preset_sources(), setting.source, &timing::PresetSource::name) == 1);
        }
    CHECK(used.size() == timing::preset_sources().size());
}

TEST_CASE("A preset that does not exist is refused, with the nearest one that does") {
    CHECK_THROWS_WITH(configured("preset:geforce2_gtx"),
                      Catch::Matchers::Contains("did you mean geforce2_gts?"));
}

TEST_CASE("docs/presets.md is what the list of presets prints") {
    INFO("ffgpu presets --page > docs/presets.md writes it anew");
    CHECK(docs::read_source("docs/presets.md") == presets_page());
}

// From the clock, the pipes and the bus alone, as data sheets of the time have them.
TEST_CASE("Presets have the peaks that their makers told") {
    struct Peak {
        const char* preset;
        double megapixels, gigabytes; // a second
    };
    for (const Peak& peak : {Peak{"voodoo_graphics", 50, 0.8},
                             Peak{"riva_tnt", 180, 1.76},
                             Peak{"geforce_256_sdr", 480, 2.656},
                             Peak{"geforce_256_ddr", 480, 4.8},
                             Peak{"geforce2_gts", 800, 5.312},
                             Peak{"geforce2_ultra", 1000, 7.36},
                             Peak{"kyro", 230, 1.84},
                             Peak{"powervr_mbx", 75, 0.4}}) {
        INFO(peak.preset);
        const timing::TimingConfig machine =
            configured("preset:" + std::string(peak.preset)).timing;
        CHECK(4.0 * machine.clock.core_mhz * machine.raster.quads_per_cycle /
                  machine.fragment.cycles(1) ==
              Approx(peak.megapixels));
        const timing::MemoryConfig& memory = machine.memory;
        CHECK(1e-3 * machine.clock.core_mhz * memory.memory_clocks / memory.core_clocks *
                  memory.channels * memory.bytes_per_cycle ==
              Approx(peak.gigabytes));
    }
}

} // namespace
} // namespace ffgpu::tools
