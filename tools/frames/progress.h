// Progress: a line on the terminal that shows that something happens; nothing in a pipe or file.

#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace ffgpu::tools {

class Progress {
public:
    // `last`: the last frame if it is known, to draw a bar.
    explicit Progress(std::optional<std::uint64_t> last);
    ~Progress(); // Clears the line.
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(std::uint64_t frame);
    void clear();

private:
    bool on_terminal_;
    std::optional<std::uint64_t> last_;
    std::chrono::steady_clock::time_point next_{};
};

} // namespace ffgpu::tools
