// The account of a backend that plays an input: what two of are compared, by this program or
// another build of it.
//
// It begins with the line AccountHeader. Of all commands: one line each, with tabs between:
//     command  frame  draw or -  call's number  its name or -  command's name  part=entries:sum ...
// Of one command: its entries (account_lines.h). It ends with "end", or with "error" and the line
// that tells why.

#pragma once

#include "driver/framebuffer/drawable.h"
#include "model/gpu/stages.h"
#include "tools/diff/account_lines.h"
#include "tools/frames/frame_range.h"

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace ffgpu::tools {

constexpr std::string_view AccountHeader = "ffgpu account 2";

// What the two sides have in common.
struct AccountQuestion {
    FrameRange frames{};
    unsigned samples = 1;
    gl::SwapMode swap = gl::SwapMode::Copy;
    std::optional<std::uint64_t> command{}; // this one's entries; nothing: a line of each command
    AccountParts parts{};                   // of the command's entries
};

// Writes the account. An InputError becomes the account's last line.
void write_account(const std::string& input,
                   const Stages& stages,
                   const AccountQuestion& question,
                   std::FILE* out);

// Draws up to the command's end, for what the stages tell of it besides.
void draw_up_to(const std::string& input,
                const Stages& stages,
                AccountQuestion question,
                std::uint64_t command);

} // namespace ffgpu::tools
