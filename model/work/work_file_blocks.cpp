#include "model/work/work_file_blocks.h"

#include "model/base/input_error.h"

#include <cerrno>
#include <cstring>

#include <zstd.h>

namespace ffgpu::work {
namespace {

constexpr std::size_t LengthBytes = 4 * ColumnCount; // before the columns: how long each is

} // namespace

WorkFileBlocks::WorkFileBlocks(const std::string& path)
    : path_(path)
    , file_(std::fopen(path.c_str(), "rb")) {
    if (!file_) throw InputError(path + ": cannot be read: " + std::strerror(errno));
    if (std::fseek(file_.get(), 0, SEEK_END) != 0) throw InputError(path + ": is no plain file");
    size_ = static_cast<std::uint64_t>(std::ftell(file_.get()));
    std::rewind(file_.get());
    std::string magic(WorkFileMagic.size(), '\0');
    std::uint32_t version = 0;
    if (size_ < magic.size() + sizeof version)
        throw InputError(path + ": byte 0: is no work file: it is too short");
    read_bytes(magic.data(), magic.size());
    if (magic != WorkFileMagic)
        throw InputError(path + ": byte 0: is no work file: expected " +
                         std::string(WorkFileMagic));
    read_bytes(&version, sizeof version);
    if (version != WorkFileVersion)
        throw InputError(path + ": byte " + std::to_string(magic.size()) +
                         ": is a work file of version " + std::to_string(version) +
                         ", but this program reads version " + std::to_string(WorkFileVersion));
}

void WorkFileBlocks::fail(const std::string& what) const {
    throw InputError(path_ + ": byte " + std::to_string(block_at_) + ": " + what);
}

void WorkFileBlocks::read_bytes(void* to, std::size_t count) {
    if (count > size_ - at_)
        throw InputError(path_ + ": byte " + std::to_string(size_) +
                         ": the file ends here, but more was expected: it was cut off");
    if (std::fread(to, 1, count, file_.get()) != count)
        throw InputError(path_ + ": byte " + std::to_string(at_) + ": cannot be read");
    at_ += count;
}

bool WorkFileBlocks::next() {
    block_at_ = at_;
    read_bytes(&header_, sizeof header_);
    if (header_.kind < static_cast<std::uint32_t>(BlockKind::Names) ||
        header_.kind > static_cast<std::uint32_t>(BlockKind::End))
        fail("the block is damaged: its kind is " + std::to_string(header_.kind));
    if (header_.raw_bytes < LengthBytes || header_.raw_bytes > MaxBlockBytes)
        fail("the block is damaged: it cannot be of " + std::to_string(header_.raw_bytes) +
             " bytes");
    if (header_.packed_bytes > size_ - at_)
        fail("the block is cut off or damaged: of " + std::to_string(header_.packed_bytes) +
             " bytes there are " + std::to_string(size_ - at_));
    std::vector<std::uint8_t> packed(header_.packed_bytes);
    read_bytes(packed.data(), packed.size());
    unpack(packed);
    divide();
    // What no checksum covers.
    if (kind() != BlockKind::Items && header_.items != 0)
        fail("the block is damaged: it can have no items, but tells of " +
             std::to_string(header_.items));
    if (kind() != BlockKind::End) return true;
    if (!columns_.at_end()) fail("the block is damaged: the last one holds nothing");
    if (at_ != size_) {
        block_at_ = at_;
        fail("expected the end of the file");
    }
    return false;
}

void WorkFileBlocks::unpack(const std::vector<std::uint8_t>& packed) {
    raw_.resize(header_.raw_bytes);
    const std::size_t count =
        ZSTD_decompress(raw_.data(), raw_.size(), packed.data(), packed.size());
    if (ZSTD_isError(count) || count != raw_.size())
        fail("the block is damaged: it does not decompress to what was written");
}

void WorkFileBlocks::divide() {
    std::size_t begin = LengthBytes;
    for (std::size_t i = 0; i < ColumnCount; ++i) {
        std::uint32_t bytes = 0;
        for (std::size_t part = 0; part < 4; ++part)
            bytes |= static_cast<std::uint32_t>(raw_[4 * i + part]) << 8 * part;
        if (bytes > raw_.size() - begin) fail("the block is damaged: a column leaves it");
        columns_.set(static_cast<Column>(i), std::span(raw_).subspan(begin, bytes));
        begin += bytes;
    }
    if (begin != raw_.size()) fail("the block is damaged: its columns do not fill it");
}

} // namespace ffgpu::work
