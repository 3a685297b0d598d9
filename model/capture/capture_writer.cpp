#include "model/capture/capture_writer.h"

#include "model/base/input_error.h"
#include "model/capture/capture_format.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <zstd.h>

namespace ffgpu::capture {
namespace {

constexpr std::size_t PageBytes = 4096;
constexpr int CompressionLevel = 1; // Speed: a capture must not slow a replay down.

bool is_zero(std::span<const std::byte> bytes) {
    return std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{}; });
}

} // namespace

CaptureWriter::CaptureWriter(Device& device)
    : device_(device) {}

CaptureWriter::~CaptureWriter() = default; // Without end() the file shows that it is not whole.

void CaptureWriter::begin(const std::string& path, std::uint32_t first_frame) {
    path_ = path;
    file_.reset(std::fopen(path.c_str(), "wb"));
    if (!file_) throw InputError(path + ": cannot be written: " + std::strerror(errno));
    // Whole chunks are written, and a child that the process forks must have nothing to flush.
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    put_bytes(Magic.data(), Magic.size());
    put_u32(Version);
    put_u32(register_map_fingerprint());
    const std::uint64_t memory = device_.memory_size();
    put_bytes(&memory, sizeof memory);
    put_u32(first_frame);
    write_file(chunk_.data(), chunk_.size());
    chunk_.clear();
    record_snapshot();
}

void CaptureWriter::end() {
    if (!file_) return;
    write_chunk();
    const std::uint64_t end_mark = 0;
    write_file(&end_mark, sizeof end_mark);
    if (std::fclose(file_.release()) != 0)
        throw InputError(path_ + ": cannot be written: " + std::strerror(errno));
}

// Memory starts as zeroes, so that only the other pages are worth a record.
void CaptureWriter::record_snapshot() {
    std::vector<std::byte> block(ChunkBytes / 2);
    const std::uint64_t size = device_.memory_size();
    for (std::uint64_t at = 0; at < size; at += block.size()) {
        const std::span bytes =
            std::span(block).first(std::min<std::uint64_t>(block.size(), size - at));
        device_.read_memory(static_cast<DeviceAddress>(at), bytes);
        for (std::size_t page = 0; page < bytes.size(); page += PageBytes) {
            const auto content = bytes.subspan(page, std::min(PageBytes, bytes.size() - page));
            if (!is_zero(content)) record_write(static_cast<DeviceAddress>(at + page), content);
        }
    }
    CommandStream commands;
    write_changes(Registers{}, shadow_.registers(), commands);
    record_commands(commands.words);
}

void CaptureWriter::frame_shown(std::uint32_t number, const Surface& picture) {
    if (!file_) return;
    std::array<std::uint32_t, WordCount<Surface>> words{};
    pack(picture, words);
    begin_record(static_cast<std::uint8_t>(Record::Shown), 4 + sizeof words);
    put_u32(number);
    put_bytes(words.data(), sizeof words);
}

void CaptureWriter::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    if (file_) record_write(at, bytes);
    device_.write_memory(at, bytes);
}

void CaptureWriter::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    device_.read_memory(at, bytes);
    if (!file_) return;
    begin_record(static_cast<std::uint8_t>(Record::ReadMemory), 8);
    put_u32(at);
    put_u32(static_cast<std::uint32_t>(bytes.size()));
}

void CaptureWriter::submit(const CommandStream& commands) {
    if (file_) record_commands(commands.words);
    shadow_.follow(commands.words);
    device_.submit(commands);
}

void CaptureWriter::finish() {
    if (file_) begin_record(static_cast<std::uint8_t>(Record::Finish), 0);
    device_.finish();
}

void CaptureWriter::record_write(DeviceAddress at, std::span<const std::byte> bytes) {
    do {
        const auto part = bytes.first(std::min(bytes.size(), MaxRecordBytes));
        begin_record(static_cast<std::uint8_t>(Record::WriteMemory), 8 + part.size());
        put_u32(at);
        put_u32(static_cast<std::uint32_t>(part.size()));
        put_bytes(part.data(), part.size());
        at += static_cast<DeviceAddress>(part.size());
        bytes = bytes.subspan(part.size());
    } while (!bytes.empty());
}

// A command does not straddle records either.
void CaptureWriter::record_commands(std::span<const std::uint32_t> words) {
    while (!words.empty()) {
        std::size_t count = 0;
        do {
            count += 1 + (words[count] & 0xffffff);
        } while (count < words.size() && count < MaxRecordBytes / 8);
        begin_record(static_cast<std::uint8_t>(Record::Submit), 4 + 4 * count);
        put_u32(static_cast<std::uint32_t>(count));
        put_bytes(words.data(), 4 * count);
        words = words.subspan(count);
    }
}

void CaptureWriter::begin_record(std::uint8_t kind, std::size_t bytes) {
    if (!chunk_.empty() && chunk_.size() + 1 + bytes > ChunkBytes) write_chunk();
    put_bytes(&kind, 1);
}

void CaptureWriter::put_u32(std::uint32_t value) {
    put_bytes(&value, sizeof value);
}

void CaptureWriter::put_bytes(const void* bytes, std::size_t count) {
    static_assert(std::endian::native == std::endian::little);
    const auto* const begin = static_cast<const std::byte*>(bytes);
    chunk_.insert(chunk_.end(), begin, begin + count);
}

void CaptureWriter::write_chunk() {
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
    if (ZSTD_isError(size)) throw InputError(path_ + ": " + ZSTD_getErrorName(size));
    const std::array<std::uint32_t, 2> sizes{static_cast<std::uint32_t>(chunk_.size()),
                                             static_cast<std::uint32_t>(size)};
    std::memcpy(compressed_.data(), sizes.data(), Sizes);
    write_file(compressed_.data(), Sizes + size);
    chunk_.clear();
}

void CaptureWriter::write_file(const void* bytes, std::size_t count) {
    if (std::fwrite(bytes, 1, count, file_.get()) != count)
        throw InputError(path_ + ": cannot be written: " + std::strerror(errno));
}

} // namespace ffgpu::capture
