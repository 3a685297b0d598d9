#include "model/capture/chunk_file.h"

#include "model/base/input_error.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include <zstd.h>

namespace ffgpu::capture {
namespace {

constexpr int CompressionLevel = 1; // Speed: a capture must not slow a replay down.
static_assert(std::endian::native == std::endian::little);

} // namespace

ChunkWriter::ChunkWriter(const std::string& path)
    : file_(path) {}

void ChunkWriter::write_plain(std::span<const std::byte> bytes) {
    file_.write(bytes);
}

void ChunkWriter::put_u32(std::uint32_t value) {
    put_bytes(&value, sizeof value);
}

void ChunkWriter::put_bytes(const void* bytes, std::size_t count) {
    const auto* const first = static_cast<const std::byte*>(bytes);
    chunk_.insert(chunk_.end(), first, first + count);
}

void ChunkWriter::write_chunk() {
    if (chunk_.empty()) return;
    constexpr std::size_t Sizes = 8;
    compressed_.resize(Sizes + ZSTD_compressBound(chunk_.size()));
    const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(),
                                                                          ZSTD_freeCCtx);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, CompressionLevel);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    const std::size_t size = ZSTD_compress2(context.get(),
                                            compressed_.data() + Sizes,
                                            compressed_.size() - Sizes,
                                            chunk_.data(),
                                            chunk_.size());
    if (ZSTD_isError(size)) throw InputError(file_.path() + ": " + ZSTD_getErrorName(size));
    const std::array<std::uint32_t, 2> sizes{static_cast<std::uint32_t>(chunk_.size()),
                                             static_cast<std::uint32_t>(size)};
    std::memcpy(compressed_.data(), sizes.data(), Sizes);
    file_.write(std::span(compressed_).first(Sizes + size));
    chunk_.clear();
}

void ChunkWriter::end() {
    write_chunk();
    const std::array<std::uint64_t, 1> end_mark{};
    file_.write(std::as_bytes(std::span(end_mark)));
    file_.commit();
}

ChunkReader::ChunkReader(std::string path)
    : path_(std::move(path))
    , file_(std::fopen(path_.c_str(), "rb")) {
    if (!file_) throw InputError(path_ + ": cannot be opened: " + std::strerror(errno));
}

void ChunkReader::rewind() {
    std::rewind(file_.get());
    file_position_ = 0;
    chunk_.clear();
    at_ = 0;
}

std::size_t ChunkReader::read_plain(std::span<std::byte> bytes) {
    const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file_.get());
    file_position_ += count;
    return count;
}

bool ChunkReader::next_chunk(std::size_t most_bytes) {
    chunk_position_ = file_position_;
    chunk_.clear();
    at_ = 0;
    std::array<std::uint32_t, 2> sizes{};
    if (read_plain(std::as_writable_bytes(std::span(sizes))) < sizeof sizes)
        damaged("the file is cut off: expected a chunk");
    const auto [size, compressed_size] = sizes;
    if (size == 0) {
        std::array<std::byte, 1> behind{};
        if (compressed_size != 0 || read_plain(behind) != 0)
            damaged("expected the end of the file");
        return false;
    }
    if (size > most_bytes || compressed_size > ZSTD_compressBound(most_bytes))
        damaged("expected a chunk of at most " + std::to_string(most_bytes) +
                " bytes, found one of " + std::to_string(size));
    compressed_.resize(compressed_size);
    if (read_plain(compressed_) < compressed_size)
        damaged("the file is cut off: expected a chunk of " + std::to_string(compressed_size) +
                " bytes");
    chunk_.resize(size);
    const std::size_t result =
        ZSTD_decompress(chunk_.data(), size, compressed_.data(), compressed_size);
    if (ZSTD_isError(result) || result != size)
        damaged(ZSTD_isError(result) ? ZSTD_getErrorName(result) : "the chunk is too short");
    return true;
}

std::uint32_t ChunkReader::take_u32() {
    std::uint32_t value = 0;
    const auto bytes = take(sizeof value);
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

std::span<const std::byte> ChunkReader::take(std::size_t bytes) {
    if (bytes > left()) damaged("a record does not end in its chunk");
    const std::size_t at = std::exchange(at_, at_ + bytes);
    return std::span(chunk_).subspan(at, bytes);
}

void ChunkReader::take_words(std::size_t count, std::vector<std::uint32_t>& words) {
    const auto bytes = take(4 * count);
    words.resize(count);
    if (count > 0) std::memcpy(words.data(), bytes.data(), bytes.size());
}

void ChunkReader::damaged(const std::string& what) const {
    throw InputError(path_ + ": chunk at byte " + std::to_string(chunk_position_) + ": " + what);
}

} // namespace ffgpu::capture
