// AccountLines: entries as text, one a line: part, place, then "field=value" ..., with tabs
// between. Numbers are as exact as they are in the machine.

#pragma once

#include "tools/diff/account_sink.h"

#include <bitset>
#include <cstdio>

#include <fmt/format.h>

namespace ffgpu::tools {

using AccountParts = std::bitset<AccountPart::Count>; // by AccountPart::index()

class AccountLines final : public AccountSink {
public:
    // Entries of other parts are left out.
    AccountLines(std::FILE* out, const AccountParts& wanted)
        : out_(out)
        , wanted_(wanted) {}

    void begin(AccountPart part, const AccountPlace& place) override;
    void integer(std::string_view field, std::int64_t value, int index) override;
    void real(std::string_view field, double value, int index) override;
    void color(std::string_view field, std::uint32_t rgba8, int index) override;
    void text(std::string_view field, std::string_view value) override;
    void end() override;

private:
    void name(std::string_view field, int index);

    std::FILE* const out_;
    const AccountParts wanted_;
    bool is_wanted_ = false; // the entry under way
    fmt::memory_buffer line_;
};

} // namespace ffgpu::tools
