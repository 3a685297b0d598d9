// What goes to a stream of this process, under Catch or beside it.

#pragma once

#include <cstdio>
#include <functional>
#include <string>

#include <unistd.h>

namespace ffgpu {

// What a call prints on a stream of this process.
inline std::string printed(std::FILE* stream, const std::function<void()>& call) {
    std::FILE* const file = std::tmpfile();
    std::fflush(stream);
    const int kept = ::dup(::fileno(stream));
    ::dup2(::fileno(file), ::fileno(stream));
    call();
    std::fflush(stream);
    ::dup2(kept, ::fileno(stream));
    ::close(kept);
    std::rewind(file);
    std::string text;
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file))
        text += static_cast<char>(c);
    std::fclose(file);
    return text;
}

} // namespace ffgpu
