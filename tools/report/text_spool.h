// TextSpool: text that waits in a nameless temporary file instead of in memory until it is wanted.
//
// A process that forks shares the file with its child: nothing is buffered here, and no position
// is kept in the system, so that a child which ends writes and moves nothing.

#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string_view>

namespace ffgpu::tools {

// Takes a text piece by piece.
using TextSink = std::function<void(std::string_view)>;

class TextSpool {
public:
    // Throws InputError, as all below, where the temporary file fails.
    TextSpool();

    void append(std::string_view text);
    void copy_to(const TextSink& out) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t size_ = 0;
};

} // namespace ffgpu::tools
