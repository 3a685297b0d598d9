// The command line in this process, what it prints, and small traces for it.

#pragma once

#include "tests/support/printed.h"
#include "tests/trace/trace_writer.h"
#include "tools/commands/command_line.h"

#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace ffgpu::tools {

inline int run(const std::vector<std::string>& arguments) {
    std::vector<const char*> pointers{"ffgpu"};
    for (const std::string& argument : arguments)
        pointers.push_back(argument.c_str());
    return run_command_line(static_cast<int>(pointers.size()), pointers.data(), "test");
}

inline std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// `frames` frames of 8x4 pixels, cleared to red, then green, then red ...; over it the lower two
// and a half rows become white, if so wanted.
inline std::string clears(unsigned frames, bool with_edge = false) {
    trace::TraceWriter writer;
    using Values = std::vector<std::function<void()>>;
    const auto integer = [&](std::int64_t value) { return [&, value] { writer.sint(value); }; };
    const auto real = [&](float value) { return [&, value] { writer.float32(value); }; };
    writer.enter(0, "glXCreateContext", {"dpy", "vis", "shareList", "direct"});
    writer.end();
    writer.leave(writer.calls++);
    writer.result();
    writer.pointer(0x1000);
    writer.end();
    writer.call(1,
                "glXMakeCurrent",
                {"dpy", "drawable", "ctx"},
                Values{integer(0), integer(5), [&] { writer.pointer(0x1000); }});
    writer.call(2,
                "glViewport",
                {"x", "y", "width", "height"},
                Values{integer(0), integer(0), integer(8), integer(4)});
    for (unsigned i = 0; i < frames; ++i) {
        const float red = i % 2 == 0 ? 1 : 0;
        writer.call(3,
                    "glClearColor",
                    {"red", "green", "blue", "alpha"},
                    Values{real(red), real(1 - red), real(0), real(1)});
        writer.call(4, "glClear", {"mask"}, Values{[&] { writer.bitmask(0, 0x4000); }});
        if (with_edge)
            writer.call(6,
                        "glRectf",
                        {"x1", "y1", "x2", "y2"},
                        Values{real(-1), real(-1), real(1), real(0.25f)});
        writer.call(5, "glXSwapBuffers", {"dpy", "drawable"}, Values{integer(0), integer(5)});
    }
    return writer.bytes;
}

} // namespace ffgpu::tools
