// AccountDigest: an account as one number a part and command, which tells whether two are alike
// without keeping them. It is a sum over the entries: their order does not matter.

#pragma once

#include "tools/diff/account_sink.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ffgpu::tools {

std::uint64_t digest_of(std::span<const std::byte> bytes);

class AccountDigest final : public AccountSink {
public:
    struct Part {
        std::uint64_t entries = 0, sum = 0;
        bool operator==(const Part&) const = default;
    };
    using Parts = std::array<Part, AccountPart::Count>; // by AccountPart::index()

    const Parts& parts() const { return parts_; }
    void reset() { parts_ = {}; }

    void begin(AccountPart part, const AccountPlace& place) override;
    void integer(std::string_view field, std::int64_t value, int index) override;
    void real(std::string_view field, double value, int index) override;
    void color(std::string_view field, std::uint32_t rgba8, int index) override;
    void text(std::string_view field, std::string_view value) override;
    void end() override;

private:
    void add(std::uint64_t word);

    Parts parts_{};
    Part* part_ = nullptr;
    std::uint64_t value_ = 0; // of the entry under way
};

} // namespace ffgpu::tools
