// The options that `replay` and `run` have in common, as the command line gives them; and as a file
// (JSON), in which `run` hands them to the program that it starts.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "tools/record/recording.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ffgpu::tools {

struct RecordingArguments {
    std::string output, frames, heat_maps, heat_scale, capture, save_work, config;
    unsigned heat_tile = 1;
    bool heat_blend = false, heat_raw = false;
    std::string views, draws;
    unsigned steps = 0;
    bool draw_table = false;
    bool draw_pixels = false;
    bool work_values = false;
    std::vector<std::string> settings;
    std::optional<std::uint32_t> threads;
    bool timing = false, no_images = false, reference = false;

    // Something is to be recorded, or the machine is another than the default.
    bool any() const;
};

void add_recording_options(CLI::App& verb, RecordingArguments& arguments);

// Of a pixel of every window: 1 or MaxSamples.
void add_samples_option(CLI::App& verb, unsigned& samples);

// What a swap leaves in the back buffer of every window.
void add_swap_option(CLI::App& verb, gl::SwapMode& swap);

// Throws InputError where an argument is wrong.
void resolve(const RecordingArguments& arguments, RecordingOptions& options);

// The settings that decide nothing, because the machine is not timed; empty: there are none.
std::string settings_without_effect(const RecordingArguments& arguments);

// Paths become absolute: the program may work in another folder.
std::string to_json(RecordingArguments arguments);
// Throws InputError.
RecordingArguments read_recording_arguments(const std::string& path);

} // namespace ffgpu::tools
