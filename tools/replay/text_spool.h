// TextSpool: text that waits in a nameless temporary file instead of in memory until it is wanted.

#pragma once

#include <cstdio>
#include <memory>
#include <ostream>
#include <string_view>

namespace ffgpu::tools {

class TextSpool {
public:
    // Throws InputError, as all below, where the temporary file fails.
    TextSpool();

    void append(std::string_view text);
    void copy_to(std::ostream& out) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
};

} // namespace ffgpu::tools
