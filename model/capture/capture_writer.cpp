#include "model/capture/capture_writer.h"

#include "model/capture/description_text.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::capture {
namespace {

constexpr std::size_t PageBytes = 4096;

bool is_zero(std::span<const std::byte> bytes) {
    return std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{}; });
}

} // namespace

void write_beginning(ChunkWriter& file, const Header& header, const Description& contract) {
    std::array<std::byte, HeaderBytes> bytes{};
    std::memcpy(bytes.data(), Magic.data(), 8);
    std::memcpy(bytes.data() + 8, &header.version, 4);
    std::memcpy(bytes.data() + 12, &header.memory_bytes, 8);
    std::memcpy(bytes.data() + 20, &header.first_frame, 4);
    file.write_plain(bytes);
    const std::string text = description_text(contract);
    file.put_bytes(text.data(), text.size());
    file.write_chunk();
}

CaptureWriter::CaptureWriter(Device& device)
    : device_(device) {}

CaptureWriter::~CaptureWriter() = default;

void CaptureWriter::begin(const std::string& path, std::uint32_t first_frame) {
    file_.emplace(path);
    write_beginning(*file_,
                    {.memory_bytes = device_.memory_size(), .first_frame = first_frame},
                    describe_contract());
    record_snapshot();
}

void CaptureWriter::end() {
    if (!file_) return;
    file_->end();
    file_.reset();
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
    write_changes(Registers{}, registers_.values(), commands);
    record_commands(commands.words);
    begin_record(Record::SnapshotEnd, 4);
    file_->put_u32(draws_);
}

void CaptureWriter::frame_shown(std::uint32_t number, const Surface& picture) {
    if (!file_) return;
    std::array<std::uint32_t, WordCount<Surface>> words{};
    pack(picture, words);
    begin_record(Record::Shown, 4 + sizeof words);
    file_->put_u32(number);
    file_->put_bytes(words.data(), sizeof words);
}

void CaptureWriter::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    if (file_) record_write(at, bytes);
    device_.write_memory(at, bytes);
}

void CaptureWriter::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    device_.read_memory(at, bytes);
    if (!file_) return;
    begin_record(Record::ReadMemory, 8);
    file_->put_u32(at);
    file_->put_u32(static_cast<std::uint32_t>(bytes.size()));
}

void CaptureWriter::submit(const CommandStream& commands) {
    device_.submit(commands); // What it refuses is no part of a capture.
    for_each_command(commands.words, [this](const CommandReader& reader) {
        const Opcode opcode = reader.opcode();
        if (opcode == Opcode::WriteRegister) registers_.write(reader.register_write());
        if (opcode == Opcode::Draw || opcode == Opcode::DrawImage) ++draws_;
    });
    if (file_) record_commands(commands.words);
}

void CaptureWriter::finish() {
    if (file_) begin_record(Record::Finish, 0);
    device_.finish();
}

void CaptureWriter::record_write(DeviceAddress at, std::span<const std::byte> bytes) {
    do {
        const auto part = bytes.first(std::min(bytes.size(), MaxRecordBytes));
        begin_record(Record::WriteMemory, 8 + part.size());
        file_->put_u32(at);
        file_->put_u32(static_cast<std::uint32_t>(part.size()));
        file_->put_bytes(part.data(), part.size());
        at += static_cast<DeviceAddress>(part.size());
        bytes = bytes.subspan(part.size());
    } while (!bytes.empty());
}

// A command does not straddle records either.
void CaptureWriter::record_commands(std::span<const std::uint32_t> words) {
    CommandReader reader(words);
    bool more = reader.next();
    while (more) {
        std::size_t count = 0;
        do {
            count += reader.whole().size();
            more = reader.next();
        } while (more && count < MaxRecordBytes / 8);
        begin_record(Record::Submit, 4 + 4 * count);
        file_->put_u32(static_cast<std::uint32_t>(count));
        file_->put_bytes(words.data(), 4 * count);
        words = words.subspan(count);
    }
}

void CaptureWriter::begin_record(Record record, std::size_t bytes) {
    if (file_->pending() > 0 && file_->pending() + 1 + bytes > ChunkBytes) file_->write_chunk();
    const auto kind = static_cast<std::uint8_t>(record);
    file_->put_bytes(&kind, 1);
}

} // namespace ffgpu::capture
