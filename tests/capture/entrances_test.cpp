// Whatever a stream may ask for, it may ask for through both entrances: submitted to the device,
// and played from a capture. Each rule is probed at both sides of its boundary.

#include "model/base/input_error.h"
#include "model/capture/capture_reader.h"
#include "model/capture/capture_writer.h"
#include "model/gpu/functional_gpu.h"
#include "tests/support/temporary_file.h"

#include <catch2/catch.hpp>

namespace ffgpu::capture {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::Equals;

constexpr std::uint32_t MemoryBytes = 1 << 20;

std::string submitted(const CommandStream& stream) {
    FunctionalGpu gpu({.memory_bytes = MemoryBytes});
    try {
        gpu.submit(stream);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

std::string played(const CommandStream& stream) {
    const TemporaryFile path("", ".ffc");
    ChunkWriter file(path.path());
    write_beginning(
        file, {.version = OldestVersion, .memory_bytes = MemoryBytes}, describe_contract());
    const auto kind = static_cast<std::uint8_t>(Record::Submit);
    file.put_bytes(&kind, 1);
    file.put_u32(static_cast<std::uint32_t>(stream.words.size()));
    file.put_bytes(stream.words.data(), 4 * stream.words.size());
    file.end();
    FunctionalGpu gpu({.memory_bytes = MemoryBytes});
    try {
        CaptureReader reader(path.path());
        reader.play_frame(gpu);
    } catch (const InputError& error) {
        const std::string text = error.what();
        CHECK_THAT(text, Contains(path.path() + ": chunk at byte "));
        CHECK(text.find('\n') == std::string::npos);
        return text.substr(text.find("command stream"));
    }
    return {};
}

// What both entrances say of a command: the same.
template <class Command>
std::string verdict(const Command& command) {
    CommandStream stream;
    stream.add(command);
    std::string text = submitted(stream);
    CHECK_THAT(played(stream), Equals(text));
    return text;
}

std::string verdict(const Registers& registers) {
    CommandStream stream;
    write_changes(Registers{}, registers, stream);
    CHECK(submitted(stream).empty()); // Registers are judged when they are used.
    stream.add(ClearCommand{});
    std::string text = submitted(stream);
    CHECK_THAT(played(stream), Equals(text));
    return text;
}

TEST_CASE("A feedback buffer has room for its count, and its size is all of it") {
    const auto feedback = [](std::uint32_t at, std::uint32_t bytes) {
        return verdict(DrawCommand{
            .output = DrawOutput::Feedback, .feedback_address = at, .feedback_bytes = bytes});
    };
    CHECK(feedback(0, 4).empty());
    CHECK_THAT(feedback(0, 3), Contains("feedback buffer"));
    CHECK(feedback(0, MemoryBytes).empty());
    CHECK(feedback(MemoryBytes - 64, 64).empty());
    CHECK_THAT(feedback(MemoryBytes - 64, 65), Contains("feedback buffer"));
    CHECK_THAT(feedback(0xfffffffc, 8), Contains("feedback buffer"));
}

TEST_CASE("The last row of an image ends with its last pixel") {
    DrawImageCommand image{.stride = 256, .width = 8, .height = 4};
    const auto at_end = [&](std::uint32_t bytes) {
        image.address = MemoryBytes - bytes;
        return verdict(image);
    };
    CHECK(at_end(3 * 256 + 32).empty());
    CHECK_THAT(at_end(3 * 256 + 31), Contains("image does not lie"));
    image.format = Format::Bitmap;
    image.width = 9;
    CHECK(at_end(3 * 256 + 2).empty());
    CHECK_THAT(at_end(3 * 256 + 1), Contains("image does not lie"));
    image.height = 0; // Nothing is read.
    CHECK(at_end(0).empty());
    image.height = 4;
    image.format = Format::Rgb565;
    CHECK_THAT(verdict(image), Contains("format is not one of images"));
    image.format = Format::Bitmap;
    image.stride = 0;
    image.width = 0x80000000;
    CHECK_THAT(verdict(image), Contains("exceeds the largest"));
}

TEST_CASE("The pixels of an image whose last row ends with memory are drawn") {
    FunctionalGpu gpu({.memory_bytes = MemoryBytes});
    Registers registers;
    registers.targets.color[0] = {
        .address = 0, .format = Format::Rgba8, .width = 8, .height = 8, .stride = 32};
    registers.scissor = {0, 0, 8, 8};
    CommandStream stream;
    write_changes(Registers{}, registers, stream);
    stream.add(DrawImageCommand{
        .address = MemoryBytes - (256 + 8), .stride = 256, .width = 2, .height = 2});
    const std::uint32_t last = 0xff123456;
    gpu.write_memory(MemoryBytes - 4, std::as_bytes(std::span(&last, 1)));
    gpu.submit(stream);
    std::uint32_t pixel = 0;
    gpu.read_memory(32 + 4, std::as_writable_bytes(std::span(&pixel, 1)));
    CHECK(pixel == last);
}

TEST_CASE("Vertices and indices lie in memory") {
    DrawCommand draw{.count = 4, .vertex_count = 4, .vertex_address = MemoryBytes - 64};
    CHECK(verdict(draw).empty());
    draw.vertex_count = 5;
    CHECK_THAT(verdict(draw), Contains("vertices do not lie"));
    draw = {.count = 4, .vertex_count = 3};
    CHECK_THAT(verdict(draw), Contains("exceed those in memory"));
    draw = {.index_type = IndexType::U16, .count = 4, .vertex_count = 3};
    draw.index_address = MemoryBytes - 8;
    CHECK(verdict(draw).empty());
    draw.index_address = MemoryBytes - 7;
    CHECK_THAT(verdict(draw), Contains("indices do not lie"));
    draw.index_type = IndexType::None; // Then there are no indices to lie anywhere.
    draw.count = 3;
    CHECK(verdict(draw).empty());
}

TEST_CASE("A texture image is whole and in memory") {
    Registers registers;
    TextureImage& image = registers.images[3];
    image.shape = {TextureKind::TwoD, Format::Rgba8, 512, 256};
    image.address = MemoryBytes / 2;
    CHECK(verdict(registers).empty());
    image.address += 64;
    CHECK_THAT(verdict(registers), Contains("texture image does not lie"));
    image.address = 0;
    for (const std::uint32_t levels : {0u, MaxTextureLevels + 1}) {
        image.shape.levels = levels;
        CHECK_THAT(verdict(registers), Contains("number of levels"));
    }
    image.shape.kind = TextureKind::None; // The unit is off.
    CHECK(verdict(registers).empty());
}

TEST_CASE("A copy's rectangle lies within its surfaces") {
    constexpr Surface Square{
        .address = 4096, .format = Format::Rgba8, .width = 16, .height = 8, .stride = 64};
    CopyRectangleCommand copy{
        .source = Square, .destination = Square, .source_x = 9, .width = 7, .height = 1};
    CHECK(verdict(copy).empty());
    copy.source_x = 10;
    CHECK_THAT(verdict(copy), Contains("leaves its surface"));
    copy.source_x = 0;
    copy.destination.address = MemoryBytes - 512;
    CHECK(verdict(copy).empty());
    ++copy.destination.address;
    CHECK_THAT(verdict(copy), Contains("surface does not lie"));
}

TEST_CASE("The sample counter's place lies in memory") {
    CHECK(verdict(StoreSampleCounterCommand{MemoryBytes - 8}).empty());
    CHECK_THAT(verdict(StoreSampleCounterCommand{MemoryBytes - 7}), Contains("sample counter"));
}

TEST_CASE("Fields hold values of their kinds, and commands their words") {
    CHECK_THAT(verdict(DrawCommand{.primitive = static_cast<PrimitiveType>(10)}),
               Contains("draw.primitive"));
    Registers registers;
    registers.stencil.back.fail = StencilOp::DecrementWrap;
    CHECK(verdict(registers).empty());
    registers.combiners[1].alpha.op = static_cast<CombineOp>(13);
    CHECK_THAT(verdict(registers), Contains("combiner.alpha_op"));

    const auto words = [](std::vector<std::uint32_t> all) {
        const CommandStream stream{std::move(all)};
        std::string text = submitted(stream);
        CHECK_THAT(played(stream), Equals(text));
        return text;
    };
    const auto write = Opcode::WriteRegister;
    CHECK_THAT(words({CommandStream::header(static_cast<Opcode>(99), 0)}), Contains("opcode 99"));
    CHECK_THAT(words({CommandStream::header(Opcode::Clear, 5)}), Contains("cut off"));
    CHECK_THAT(words({CommandStream::header(Opcode::EndFrame, 1), 0}), Contains("expected 0"));
    CHECK_THAT(words({CommandStream::header(write, 1), RegisterCount}), Contains("no register"));
    CHECK_THAT(words({CommandStream::header(write, 0)}), Contains("without an address"));
}

} // namespace
} // namespace ffgpu::capture
