// Carrying out a suite: each trace is drawn, each picture compared.

#pragma once

#include "tools/check/suite.h"
#include "tools/image/compare_images.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::tools {

enum class Verdict : std::uint8_t { Passed, Failed, Error };

struct CheckedFrame {
    std::string trace;
    std::string name; // frame_0000, or "replay" where the trace could not be drawn
    Verdict verdict = Verdict::Passed;
    std::string message;                  // one line; of an error what is wrong
    std::optional<Difference> difference; // where both pictures are there and equally large
    // Files in the output folder, where they are there; the reference's copy stands beside what
    // differs.
    std::string picture, reference, difference_picture;
};

struct CheckOptions {
    std::string output;  // a folder
    bool update = false; // References become what is drawn now.
    std::function<void(const std::string&)> warn = [](const std::string&) {};
    std::function<void(const CheckedFrame&)> on_frame = [](const CheckedFrame&) {};
};

// In the order of the suite. Throws InputError where the output cannot be written, or holds the
// references, which would be written over; what is wrong with a trace or a reference is an error of
// its frame. After an Interruption the frames that are drawn are compared, and what is not drawn is
// an error.
std::vector<CheckedFrame> check_suite(const Suite& suite, const CheckOptions& options);

} // namespace ffgpu::tools
