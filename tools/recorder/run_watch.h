// Whether the `ffgpu run` that started this process, or one before it, is still there. The signal
// of a parent's death reaches its children alone: a program that a script has started would draw
// and write on.

#pragma once

#include <functional>
#include <string>

namespace ffgpu::tools {

// Calls `lost` on a thread of its own once `ffgpu run` was killed. It holds the lock of the file
// with its settings as long as it lives, and takes the file away where it ends by itself.
void on_lost_run(const std::string& settings_path, std::function<void()> lost);

} // namespace ffgpu::tools
