// Presets: machines after chips of the time, and the pipe that is there in RTL, by name. A preset
// is a list of parameters that differ from the defaults, each with the public source of its value,
// or why it is assumed. docs/presets.md is printed from it.

#pragma once

#include <span>
#include <string_view>

namespace ffgpu::timing {

// A source that several parameters share.
struct PresetSource {
    std::string_view name;  // as the settings call it
    std::string_view where; // author or publisher, title, address
};

struct PresetSetting {
    std::string_view parameter; // group.field
    std::string_view value;
    std::string_view source; // PresetSource::name, or "assumed"
    std::string_view reason; // how the value follows
};

struct Preset {
    std::string_view name;
    std::string_view chip;                   // with its year
    std::span<const PresetSetting> settings; // applied in this order
};

std::span<const Preset> presets();
std::span<const PresetSource> preset_sources();
// Null where there is none.
const Preset* find_preset(std::string_view name);

} // namespace ffgpu::timing
