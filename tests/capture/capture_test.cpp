#include "model/base/input_error.h"
#include "model/capture/capture_format.h"
#include "model/capture/capture_reader.h"
#include "model/capture/capture_writer.h"
#include "tests/support/temporary_file.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::capture {
namespace {

using Catch::Matchers::Contains;

// A device of memory and registers that remembers the commands it got.
class MemoryDevice : public Device {
public:
    std::uint64_t memory_size() const override { return memory.size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        std::copy(bytes.begin(), bytes.end(), memory.begin() + at);
    }
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override {
        std::copy_n(memory.begin() + at, bytes.size(), bytes.begin());
    }
    void submit(const CommandStream& commands) override {
        for_each_command(commands.words, [this](const CommandReader& reader) {
            if (reader.opcode() == Opcode::WriteRegister) registers.write(reader.register_write());
        });
        words.insert(words.end(), commands.words.begin(), commands.words.end());
    }
    void finish() override {}
    std::vector<const StatisticsGroup*> statistics() const override { return {}; }

    std::vector<std::byte> memory = std::vector<std::byte>(1 << 20);
    RegisterFile registers;
    std::vector<std::uint32_t> words;
};

constexpr std::uint32_t FogAddress = find_register_address<&Registers::fog>();

void write(Device& device, DeviceAddress at, std::initializer_list<int> bytes) {
    std::vector<std::byte> content;
    for (const int byte : bytes)
        content.push_back(static_cast<std::byte>(byte));
    device.write_memory(at, content);
}

void set_fog(Device& device, float density) {
    Fog fog;
    fog.density = density;
    CommandStream commands;
    commands.write(FogAddress, fog);
    commands.add(DrawCommand{});
    commands.add(Opcode::EndFrame);
    device.submit(commands);
}

constexpr Surface Shown{
    .address = 4096, .format = Format::Rgba8, .width = 16, .height = 8, .stride = 64};

// Something before the capture, two frames in it.
void record(Device& target, const std::string& path) {
    CaptureWriter writer(target);
    write(writer, 10, {1, 2, 3});
    write(writer, 500000, {9});
    set_fog(writer, 0.25f);
    writer.begin(path, 7);
    writer.frame_shown(7, Shown);
    write(writer, 11, {8});
    set_fog(writer, 0.5f);
    std::array<std::byte, 4> seen{};
    writer.read_memory(10, seen);
    writer.finish();
    writer.frame_shown(8, {});
    writer.end();
    write(writer, 600000, {77}); // Not in the file.
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE("A capture begins with what the device held and repeats the calls that followed") {
    const TemporaryFile file("", ".ffc");
    MemoryDevice original, copy;
    record(original, file.path());

    CHECK(CaptureReader::is_capture(file.path()));
    CaptureReader reader(file.path());
    CHECK(reader.memory_size() == original.memory.size());
    CHECK(reader.first_frame() == 7);
    const auto first = reader.play_frame(copy);
    REQUIRE(first);
    CHECK(first->frame == 7);
    CHECK(first->picture == Shown);
    CHECK(copy.registers.values().fog.density == 0.25f);
    CHECK(std::to_integer<int>(copy.memory[11]) == 2);
    CHECK(std::to_integer<int>(copy.memory[500000]) == 9);

    const auto second = reader.play_frame(copy);
    REQUIRE(second);
    CHECK(second->picture.format == Format::None);
    CHECK(copy.registers.values() == original.registers.values());
    CHECK(!reader.play_frame(copy));
    original.memory[600000] = std::byte{}; // Written after the end.
    CHECK(copy.memory == original.memory);
}

TEST_CASE("A snapshot is played by itself, and tells the number of the first draw") {
    const TemporaryFile file("", ".ffc");
    MemoryDevice original, copy;
    record(original, file.path());
    CaptureReader reader(file.path());
    reader.play_snapshot(copy);
    CHECK(reader.first_draw() == 1);
    CHECK(copy.registers.values().fog.density == 0.25f);
    CHECK(std::to_integer<int>(copy.memory[500000]) == 9);
    const std::vector<std::byte> snapshot = copy.memory;
    reader.play_snapshot(copy); // Once is enough.
    CHECK(reader.play_frame(copy)->frame == 7);
    CHECK(copy.memory == snapshot);
}

// What playing the file ends with.
std::string outcome(const std::string& bytes) {
    const TemporaryFile file(bytes, ".ffc");
    MemoryDevice device;
    try {
        CaptureReader reader(file.path());
        while (reader.play_frame(device)) {
        }
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

// A file of that version whose one record is `record`.
std::string small_capture(std::uint32_t version, Record record) {
    const TemporaryFile file("", ".ffc");
    ChunkWriter writer(file.path());
    write_beginning(writer, {.version = version, .memory_bytes = 1 << 20}, describe_contract());
    writer.put_bytes(&record, 1);
    writer.put_u32(3);
    if (record == Record::Shown) {
        const std::array<std::uint32_t, WordCount<Surface>> none{};
        writer.put_bytes(none.data(), sizeof none);
    }
    writer.end();
    return bytes_of(file.path());
}

TEST_CASE("Captures of version 3 have no end of their snapshot, later ones need it") {
    const TemporaryFile old(small_capture(3, Record::Shown), ".ffc");
    CaptureReader reader(old.path());
    MemoryDevice device;
    reader.play_snapshot(device);
    CHECK(reader.first_draw() == 0);
    CHECK(reader.play_frame(device)->frame == 3);

    CHECK(outcome(small_capture(4, Record::SnapshotEnd)).empty());
    CHECK_THAT(outcome(small_capture(4, Record::Shown)), Contains("the end of the snapshot"));
    CHECK_THAT(outcome(small_capture(3, Record::SnapshotEnd)), Contains("end of the snapshot"));
}

TEST_CASE("A capture is played again from its beginning") {
    const TemporaryFile file("", ".ffc");
    MemoryDevice original, first, second;
    record(original, file.path());
    CaptureReader reader(file.path());
    while (reader.play_frame(first)) {
    }
    reader.rewind();
    while (reader.play_frame(second)) {
    }
    CHECK(first.words == second.words);
    CHECK(first.memory == second.memory);
}

TEST_CASE("A capture cut at any byte or with any byte flipped ends in one line") {
    const TemporaryFile file("", ".ffc");
    MemoryDevice original;
    record(original, file.path());
    const std::string bytes = bytes_of(file.path());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::string error = outcome(bytes.substr(0, size));
        INFO(size);
        CHECK(!error.empty());
        CHECK(error.find('\n') == std::string::npos);
    }
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        CHECK(outcome(damaged).find('\n') == std::string::npos);
    }
}

TEST_CASE("Nothing may stand behind a capture's end") {
    const TemporaryFile file("", ".ffc");
    MemoryDevice original;
    record(original, file.path());
    const std::string bytes = bytes_of(file.path());
    CHECK(outcome(bytes).empty());
    for (const std::string& rest : {std::string("x"), bytes})
        CHECK_THAT(outcome(bytes + rest),
                   Catch::Matchers::Contains("expected the end of the file"));
}

TEST_CASE("A capture of another version is refused") {
    const TemporaryFile file("", ".ffc");
    MemoryDevice original;
    record(original, file.path());
    std::string bytes = bytes_of(file.path());
    for (const char version : {char{1}, char{2}, static_cast<char>(Version + 1)}) {
        bytes[8] = version;
        CHECK_THAT(outcome(bytes), Contains("byte 8: capture version " + std::to_string(version)));
        CHECK_THAT(outcome(bytes.substr(0, 12)), Contains("capture version")); // Shorter headers.
    }
}

TEST_CASE("A capture's beginning that is cut off is told with the byte") {
    const TemporaryFile file("", ".ffc");
    MemoryDevice original;
    record(original, file.path());
    const std::string bytes = bytes_of(file.path());
    CHECK_THAT(outcome(""), Contains("byte 0: not a capture"));
    CHECK_THAT(outcome(bytes.substr(0, 11)), Contains("byte 0: not a capture"));
    CHECK_THAT(outcome(bytes.substr(0, 12)), Contains("byte 12: the header is cut off"));
    CHECK_THAT(outcome(bytes.substr(0, 23)), Contains("byte 23: the header is cut off"));
    CHECK_THAT(outcome(bytes.substr(0, 24)), Contains("byte 24: the file is cut off"));
}

// A capture of the frames with these numbers.
std::string capture_of(std::uint32_t first, const std::vector<std::uint32_t>& frames) {
    const TemporaryFile file("", ".ffc");
    MemoryDevice device;
    CaptureWriter writer(device);
    writer.begin(file.path(), first);
    for (const std::uint32_t frame : frames)
        writer.frame_shown(frame, {});
    writer.end();
    return bytes_of(file.path());
}

TEST_CASE("The frames of a capture count up from its first") {
    CHECK(outcome(capture_of(3, {3, 4, 6})).empty());
    CHECK_THAT(outcome(capture_of(3, {2})), Contains("expected frame 3 or a later one, found 2"));
    CHECK_THAT(outcome(capture_of(3, {3, 3})), Contains("expected frame 4 or a later one"));
    CHECK(outcome(capture_of(~0u, {~0u})).empty());
    CHECK_THAT(outcome(capture_of(0, {~0u, ~0u})), Contains("expected frame 4294967296"));
}

TEST_CASE("A capture without a frame is told of with its end's place") {
    const std::string bytes = capture_of(5, {});
    const TemporaryFile file(bytes, ".ffc");
    MemoryDevice device;
    CaptureReader reader(file.path());
    CHECK(!reader.play_frame(device));
    CHECK_THROWS_WITH(reader.expect_frames(),
                      Contains("byte " + std::to_string(bytes.size() - 8)) &&
                          Contains("expected a frame"));
    const TemporaryFile one(capture_of(5, {5}), ".ffc");
    CaptureReader other(one.path());
    while (other.play_frame(device)) {
    }
    CHECK_NOTHROW(other.expect_frames());
}

} // namespace
} // namespace ffgpu::capture
