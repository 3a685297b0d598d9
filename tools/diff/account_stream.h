// AccountStream: the account of one side, line by line, as a process of its own writes it: this
// program, forked, or another build's. It writes no further ahead than a pipe holds.

#pragma once

#include "tools/diff/account.h"

#include <cstdio>
#include <optional>
#include <string>

#include <sys/types.h>

namespace ffgpu::tools {

struct AccountSide {
    std::string input;
    std::string backend = "functional"; // a Backend's name
    std::string program{};              // another build's ffgpu; empty: this one
    const Stages* stages = nullptr;     // instead of the backend's
};

class AccountStream {
public:
    // Throws InputError where there is no such backend, or the other program cannot be started.
    AccountStream(const AccountSide& side, const AccountQuestion& question);
    ~AccountStream();
    AccountStream(const AccountStream&) = delete;
    AccountStream& operator=(const AccountStream&) = delete;

    // Without its end; nothing behind the last one. Throws InputError where the side failed.
    std::optional<std::string> next_line();

private:
    std::string read_line();

    const AccountSide side_;
    std::FILE* in_ = nullptr;
    pid_t process_ = -1;
    bool begun_ = false;
};

} // namespace ffgpu::tools
