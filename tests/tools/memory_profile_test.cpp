// A profile of the memory in a configuration: what is said beside it, or after it, goes before it.

#include "tests/support/temporary_file.h"
#include "tools/config/config_file.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

TEST_CASE("A profile sets the timings that nothing else is said of") {
    Configuration configuration;
    apply_setting("memory.profile=gddr3", configuration);
    timing::MemoryConfig gddr3;
    gddr3.profile = timing::MemoryProfile::Gddr3;
    gddr3.apply_profile();
    CHECK(configuration.timing.memory == gddr3);
    apply_setting("memory.column_cycles=11", configuration);
    gddr3.column_cycles = 11;
    CHECK(configuration.timing.memory == gddr3);

    // In a file the order of the lines does not matter.
    const TemporaryFile file("[memory]\ncolumn_cycles = 11\nprofile = \"gddr3\"\n", ".toml");
    Configuration read;
    read_config_file(file.path(), read);
    CHECK(read.timing.memory == gddr3);
    // What is printed is read back, though it names a profile.
    const TemporaryFile printed(to_toml(read), ".toml");
    Configuration again;
    read_config_file(printed.path(), again);
    CHECK(again.timing.memory == gddr3);
    CHECK_THROWS(apply_setting("memory.profile=rambus", again));
}

} // namespace
} // namespace ffgpu::tools
