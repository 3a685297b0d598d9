#include "tools/diff/account_digest.h"

#include <bit>

namespace ffgpu::tools {
namespace {

// The finaliser of MurmurHash3 (Appleby): every bit of the word reaches every bit of the result.
constexpr std::uint64_t mixed(std::uint64_t word) {
    word = (word ^ word >> 33) * 0xff51afd7ed558ccd;
    word = (word ^ word >> 33) * 0xc4ceb9fe1a85ec53;
    return word ^ word >> 33;
}

} // namespace

std::uint64_t digest_of(std::span<const std::byte> bytes) {
    std::uint64_t value = bytes.size();
    for (const std::byte byte : bytes) // FNV-1a
        value = (value ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
    return mixed(value);
}

void AccountDigest::add(std::uint64_t word) {
    value_ = mixed(value_ ^ word) + 0x9e3779b97f4a7c15; // so that zeroes count
}

void AccountDigest::begin(AccountPart part, const AccountPlace& place) {
    part_ = &parts_[part.index()];
    value_ = 0;
    add(std::uint64_t{place.primitive} << 32 | place.piece);
    add(std::uint64_t{place.x} << 32 | place.y);
    add(static_cast<std::uint64_t>(place.kind) << 16 | std::uint64_t{place.lane} << 8 |
        place.sample);
}

void AccountDigest::integer(std::string_view, std::int64_t value, int) {
    add(static_cast<std::uint64_t>(value));
}

void AccountDigest::real(std::string_view, double value, int) {
    add(std::bit_cast<std::uint64_t>(value));
}

void AccountDigest::color(std::string_view, std::uint32_t rgba8, int) {
    add(rgba8);
}

void AccountDigest::text(std::string_view field, std::string_view value) {
    add(digest_of(std::as_bytes(std::span(field))));
    add(digest_of(std::as_bytes(std::span(value))));
}

void AccountDigest::end() {
    ++part_->entries;
    part_->sum += mixed(value_);
}

} // namespace ffgpu::tools
