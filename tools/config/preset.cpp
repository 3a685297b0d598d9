#include "tools/config/preset.h"

#include "model/base/input_error.h"
#include "model/timing/presets.h"
#include "tools/config/config_file.h"
#include "tools/config/nearest_name.h"

#include <vector>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr std::string_view Prefix = "preset:";

} // namespace

bool is_preset(std::string_view config) {
    return config.starts_with(Prefix);
}

void apply_preset(const std::string& config, Configuration& configuration) {
    const std::string name = config.substr(Prefix.size());
    const timing::Preset* const preset = timing::find_preset(name);
    if (!preset) {
        std::vector<std::string> names;
        for (const timing::Preset& each : timing::presets())
            names.emplace_back(each.name);
        throw InputError(fmt::format("--config: unknown preset {}; did you mean {}? (ffgpu "
                                     "presets lists them)",
                                     name,
                                     nearest_name(name, names)));
    }
    for (const timing::PresetSetting& setting : preset->settings)
        apply_setting(fmt::format("{}={}", setting.parameter, setting.value), configuration);
}

std::string list_presets() {
    std::string text;
    for (const timing::Preset& preset : timing::presets())
        text += fmt::format("{:<18} {}\n", preset.name, preset.chip);
    return text;
}

std::string presets_page() {
    std::string text = R"(# Presets

Machines after chips of the time: `--config preset:NAME` with `replay`, `run`, `time` and `config`; `ffgpu presets` lists them. A preset is the defaults
but for the parameters below. What no public source tells is assumed, and says so; nothing was fitted to a measurement. All other parameters
(caches, queues, latencies) are the defaults, which no source stands behind. `ffgpu presets --page` prints this page.
)";
    for (const timing::Preset& preset : timing::presets()) {
        text +=
            fmt::format("\n## {}\n\n{}.\n\n| parameter | value | source | |\n|---|---|---|---|\n",
                        preset.name,
                        preset.chip);
        for (const timing::PresetSetting& setting : preset.settings)
            text += fmt::format("| `{}` | {} | {} | {} |\n",
                                setting.parameter,
                                setting.value,
                                setting.source,
                                setting.reason);
    }
    text += "\n## Sources\n\n| | |\n|---|---|\n";
    for (const timing::PresetSource& source : timing::preset_sources())
        text += fmt::format("| {} | {} |\n", source.name, source.where);
    return text + R"(
## Measured on the chips

`./dev fill_rate` draws full screens of 1024 x 768 on the presets and compares with fill rates that were measured on the boards (Tom's Hardware,
NVIDIA Strikes Back: The GeForce2 Ultra 3D Monster, 2000: 3DMark2000's fill rate test). What that test draws in detail is not public; here each layer is one
quad with a bilinear texture of 256 x 256 over the whole screen, depth tested and written, opaque, in colours and depth of 16 or of 32 bits.
)";
}

} // namespace ffgpu::tools
