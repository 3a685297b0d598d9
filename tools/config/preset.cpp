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
        throw InputError(fmt::format("{}: unknown preset; did you mean {}? (ffgpu presets lists "
                                     "them)",
                                     config,
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

`./dev fill_rate` draws full screens of 1024 x 768 on the presets and compares with the rates that 3DMark2000's fill rate test had on the boards
(T. Pabst, NVIDIA Strikes Back: The GeForce2 Ultra 3D Monster, Tom's Hardware 2000). Of that test it is told that it draws "four textured geometry layers", and
"one geometry layer with four textures, rendered with multi-texturing" (nvnews.net, 3DMark 2000, Test Descriptions), here two passes of two textures. Not told
are the following, and assumed: colour and depth are cleared; a layer is one rectangle over the screen, depth tested and written, with bilinear textures of 256 x 256, all in 16
or all in 32 bits; the screen shows another frame at 85 Hz. Not told either, and drawn both ways: whether layers blend, and whether the second pass of a layer, which must blend, writes
the depths again that it finds. Games of that year left them (P. Jaquays and B. Hook, Quake III Arena Shader Manual, 1999, `depthWrite`: by default not for blended surfaces).

Texels a second, as parts of the peak; met is what lies within 0.15 of what was measured, or in its range:

| preset | bits | textures a layer | peak, Mtexel/s | measured | opaque, or depths left | blended, depths written again | |
|---|---|---|---|---|---|---|---|
| `riva_tnt` | 16 | 1 | 180 | 0.78 | 0.90 | 0.88 | met |
| `riva_tnt` | 16 | 2 | 180 | 0.83 | 0.90 | 0.90 | met |
| `riva_tnt` | 32 | 1 | 180 | "usually halving": 0.40 to 0.65 | 0.53 | 0.43 | met |
| `geforce2_ultra` | 16 | 1 | 1000 | 0.79 | 0.75 | 0.65 | met |
| `geforce2_ultra` | 16 | 2 | 2000 | 0.80 | 0.67 | 0.61 | met where the second pass leaves the depths |
| `geforce2_ultra` | 32 | 1 | 1000 | "usually halving": 0.40 to 0.65 | 0.43 | 0.35 | met where layers are opaque |

In the fifth row 0.80 of the peak leaves 1.97 ms. Clear, first pass and blended second pass move 14.2 MB, or 12.6 MB where depths are left: 1.93 or 1.71 ms of a bus that never rests.
Here rows and changes between reads and writes take a seventh beside; the board's test moved less, by a way that is not told, or lost less.
)";
}

} // namespace ffgpu::tools
