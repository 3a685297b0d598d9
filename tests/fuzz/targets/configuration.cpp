// A configuration file; what it says is printed, and read again as the same.

#include "model/base/check.h"
#include "model/base/input_error.h"
#include "tests/fuzz/memory_file.h"
#include "tools/config/config_file.h"

void ffgpu::fuzz::run(Bytes bytes) {
    const MemoryFile file(bytes);
    tools::Configuration configuration;
    try {
        tools::read_config_file(file.path(), configuration);
    } catch (const InputError&) {
        return;
    }
    const std::string text = tools::to_toml(configuration);
    const MemoryFile printed({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    tools::Configuration again;
    tools::read_config_file(printed.path(), again);
    check(tools::to_toml(again) == text, "a configuration does not read back as it was printed");
}
