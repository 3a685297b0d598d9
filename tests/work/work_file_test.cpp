// The work file: what is written is read again; what is damaged, cut off or newer is told so.

#include "model/base/input_error.h"
#include "model/work/work_file_reader.h"
#include "tests/work/recorded_work.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <random>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <zstd.h>

namespace ffgpu::work {
namespace {

using Catch::Matchers::Contains;

CommandList read_back(const std::string& bytes, std::vector<FrameFigures>* frames = nullptr) {
    const TemporaryFile file(bytes, ".ffw");
    CommandList list;
    WorkFileReader reader(file.path());
    reader.play(list, [&](const FrameFigures& figures) {
        if (frames) frames->push_back(figures);
    });
    return list;
}

// What is wrong with the file; empty: nothing.
std::string complaint(const std::string& bytes) {
    try {
        read_back(bytes);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

// Of each quad and unit.
std::vector<std::vector<TexelAccess>> reads_of(const WholeCommand& command) {
    std::vector<std::vector<TexelAccess>> reads;
    for (std::size_t quad = 0; quad < command.quads.size(); ++quad)
        for (std::size_t unit = 0; unit < command.units.size(); ++unit) {
            const QuadReads of = command.accesses_of(quad, unit);
            reads.emplace_back(of.begin(), of.end());
        }
    return reads;
}

void check_equal(const WholeCommand& a, const WholeCommand& b) {
    CHECK(a.draw.kind == b.draw.kind);
    CHECK(a.draw.number == b.draw.number);
    CHECK(a.draw.early_depth == b.draw.early_depth);
    CHECK((a.draw.state != nullptr) == (b.draw.state != nullptr));
    if (a.draw.state) CHECK(*a.draw.state == *b.draw.state);
    CHECK(a.draw.geometry.vertices == b.draw.geometry.vertices);
    CHECK((a.draw.geometry.primitives == b.draw.geometry.primitives));
    CHECK((a.draw.geometry.pieces == b.draw.geometry.pieces));
    CHECK(a.draw.geometry.interpolants == b.draw.geometry.interpolants);
    CHECK(a.draw.register_writes == b.draw.register_writes);
    CHECK(a.draw.register_words == b.draw.register_words);
    CHECK(a.draw.geometry.vertex_address == b.draw.geometry.vertex_address);
    CHECK(a.draw.clear.color_value == b.draw.clear.color_value);
    CHECK(a.draw.copy.destination == b.draw.copy.destination);
    CHECK(a.draw.image.zoom_x == b.draw.image.zoom_x);
    CHECK(a.units == b.units);
    CHECK((a.quads == b.quads)); // Too many to be printed.
    CHECK((reads_of(a) == reads_of(b)));
}

TEST_CASE("What is written is read again, whole") {
    const auto samples = GENERATE(std::uint8_t{1}, std::uint8_t{MaxSamples});
    const CommandList list = recorded({}, samples);
    const CommandList read = read_back(file_of(list));
    REQUIRE(read.commands.size() == list.commands.size());
    for (std::size_t i = 0; i < list.commands.size(); ++i)
        check_equal(*read.commands[i], *list.commands[i]);
    REQUIRE(read.transfers.size() == list.transfers.size());
    CHECK(read.log.ends_with("we"));
}

TEST_CASE("A command larger than a block, with accesses of any kind, is read again") {
    std::mt19937 random(3);
    auto whole = std::make_shared<WholeCommand>();
    Registers registers;
    whole->draw.state = std::make_shared<const Registers>(registers);
    whole->units = {1, 6};
    for (std::uint32_t i = 0; i < 60000; ++i) {
        const auto bits = random();
        whole->quads.push_back({.primitive = i / 7,
                                .piece = i % 7,
                                .x = 20,
                                .y = 40,
                                .covered = static_cast<std::uint8_t>(bits & 15),
                                .after_early_depth = static_cast<std::uint8_t>(bits >> 4 & 15),
                                .after_coverage = static_cast<std::uint8_t>(bits >> 8 & 15),
                                .after_alpha = static_cast<std::uint8_t>(bits >> 12 & 15),
                                .after_stencil = static_cast<std::uint8_t>(bits >> 16 & 15),
                                .after_depth = static_cast<std::uint8_t>(bits >> 20 & 15),
                                .samples_covered = static_cast<std::uint16_t>(random()),
                                .samples_written = static_cast<std::uint16_t>(random())});
        for (unsigned unit = 0; unit < 2; ++unit) {
            for (unsigned lane = 0; lane < 4 && random() % 8 != 0; ++lane) {
                TexelAccess access{};
                access.lane = static_cast<std::uint16_t>(lane);
                access.level = static_cast<std::uint8_t>(random() % 12);
                access.linear = static_cast<std::uint8_t>(random() % 8);
                for (std::uint16_t* const value : {&access.x0,
                                                   &access.x1,
                                                   &access.y0,
                                                   &access.y1,
                                                   &access.layer0,
                                                   &access.layer1})
                    *value = static_cast<std::uint16_t>(random());
                whole->add_access(unit, access);
            }
        }
    }
    for (std::uint32_t i = 0; i < 400000; ++i)
        whole->draw.geometry.vertices.push_back(static_cast<std::uint32_t>(random()));
    CommandList list;
    list.commands.push_back(whole);
    const CommandList read = read_back(file_of(list));
    REQUIRE(read.commands.size() == 1);
    check_equal(*read.commands[0], *whole);
}

TEST_CASE("A frame's figures are read again") {
    const FrameFigures figures{.number = 7,
                               .width = 640,
                               .height = 480,
                               .api_calls = 1234567890123,
                               .functional = {{"draws", 3}, {"fragments_written", ~0ull}}};
    const TemporaryFile file("", ".ffw");
    WorkFileWriter writer(file.path());
    writer.frame(figures);
    writer.finish();
    std::vector<FrameFigures> frames;
    read_back(content(file.path()), &frames);
    REQUIRE(frames.size() == 1);
    CHECK(frames[0] == figures);
}

TEST_CASE("A file of a newer version is refused in one line") {
    std::string bytes = file_of(CommandList{});
    bytes[WorkFileMagic.size()] = static_cast<char>(WorkFileVersion + 1);
    CHECK_THAT(complaint(bytes),
               Contains("byte 8: is a work file of version " + std::to_string(WorkFileVersion + 1) +
                        ", but this program reads version " + std::to_string(WorkFileVersion)));
    CHECK_THAT(complaint("FFGPUWRX" + bytes.substr(8)), Contains("byte 0: is no work file"));
    CHECK_THAT(complaint("FF"), Contains("byte 0: is no work file"));
}

TEST_CASE("A file that was cut off is refused wherever that was") {
    const std::string bytes = file_of(recorded({}));
    REQUIRE(complaint(bytes).empty());
    std::mt19937 random(1);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + random() % 997) {
        INFO(size << " of " << bytes.size() << " bytes");
        CHECK_THAT(complaint(bytes.substr(0, size)), Contains("byte "));
    }
    CHECK_THAT(complaint(bytes.substr(0, bytes.size() - 1)), Contains("byte "));
    CHECK_THAT(complaint(bytes + '\0'), Contains("expected the end of the file"));
}

TEST_CASE("A file in which a byte was changed is refused, or says the same") {
    const std::string bytes = file_of(recorded({}));
    std::mt19937 random(2);
    unsigned refused = 0;
    for (unsigned i = 0; i < 300; ++i) {
        std::string damaged = bytes;
        const std::size_t at = 12 + random() % (bytes.size() - 12);
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
        INFO("byte " << at);
        const std::string what = complaint(damaged);
        if (!what.empty()) {
            CHECK_THAT(what, Contains(": byte "));
            ++refused;
        }
    }
    CHECK(refused > 290); // A bit that zstd does not use may be either.
}

// Where the blocks' headers are.
std::vector<std::size_t> headers_of(const std::string& bytes) {
    std::vector<std::size_t> places;
    for (std::size_t at = 12; at < bytes.size();) {
        BlockHeader header;
        std::memcpy(&header, bytes.data() + at, sizeof header);
        places.push_back(at);
        at += sizeof header + header.packed_bytes;
    }
    return places;
}

TEST_CASE("A file in which a bit of a block's header was changed is refused") {
    const std::string bytes = file_of(recorded({}));
    REQUIRE(complaint(bytes).empty());
    const std::vector<std::size_t> headers = headers_of(bytes);
    REQUIRE(headers.size() >= 3);
    for (const std::size_t header : headers)
        for (std::size_t bit = 0; bit < 8 * sizeof(BlockHeader); ++bit) {
            std::string damaged = bytes;
            damaged[header + bit / 8] = static_cast<char>(damaged[header + bit / 8] ^ 1 << bit % 8);
            INFO("bit " << bit << " of the header at byte " << header);
            CHECK_THAT(complaint(damaged), Contains(": byte "));
        }
}

TEST_CASE("A block of fewer items than it holds is refused, also the last") {
    const std::string bytes = file_of(recorded({}));
    for (const std::size_t at : headers_of(bytes)) {
        BlockHeader header;
        std::memcpy(&header, bytes.data() + at, sizeof header);
        if (header.kind != static_cast<std::uint32_t>(BlockKind::Items)) continue;
        for (std::uint32_t fewer = 1; fewer <= 2; ++fewer) {
            std::string damaged = bytes;
            BlockHeader changed = header;
            changed.items -= fewer;
            std::memcpy(damaged.data() + at, &changed, sizeof changed);
            INFO(fewer << " fewer in the block at byte " << at);
            CHECK_THAT(complaint(damaged), Contains("damaged"));
        }
    }
}

TEST_CASE("A block that claims to be large is refused before memory is taken for it") {
    std::string bytes = file_of(CommandList{});
    const std::uint32_t large = 0xfffffff0;
    std::string raw = bytes, packed = bytes;
    std::memcpy(raw.data() + 12 + offsetof(BlockHeader, raw_bytes), &large, 4);
    CHECK_THAT(complaint(raw),
               Contains("byte 12: the block is damaged: it cannot be of 4294967280"));
    std::memcpy(packed.data() + 12 + offsetof(BlockHeader, packed_bytes), &large, 4);
    CHECK_THAT(complaint(packed), Contains("byte 12: the block is cut off or damaged"));
}

// The file with its first block's bytes changed by change(bytes): as if another program had
// written it.
template <class Change>
std::string with_first_block(const std::string& bytes, Change&& change) {
    BlockHeader header;
    const std::size_t at = 12 + sizeof header;
    std::memcpy(&header, bytes.data() + 12, sizeof header);
    std::string raw(header.raw_bytes, '\0');
    ZSTD_decompress(raw.data(), raw.size(), bytes.data() + at, header.packed_bytes);
    const std::string rest = bytes.substr(at + header.packed_bytes);
    change(raw);
    std::string packed(ZSTD_compressBound(raw.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), 1));
    header.raw_bytes = static_cast<std::uint32_t>(raw.size());
    header.packed_bytes = static_cast<std::uint32_t>(packed.size());
    return bytes.substr(0, 12) +
           std::string(reinterpret_cast<const char*>(&header), sizeof header) + packed + rest;
}

// The file with another name for a field.
std::string renamed(const std::string& bytes, const std::string& from, const std::string& to) {
    return with_first_block(bytes, [&](std::string& raw) {
        const std::size_t place = raw.find(from);
        REQUIRE(place != std::string::npos);
        REQUIRE(from.size() == to.size());
        raw.replace(place, to.size(), to);
    });
}

TEST_CASE("A block whose columns are shorter than it is refused") {
    const std::string bytes = file_of(recorded({}));
    CHECK_THAT(complaint(with_first_block(bytes, [](std::string& raw) { raw += '\0'; })),
               Contains("byte 12: the block is damaged: its columns do not fill it"));
}

TEST_CASE("Quads that are not in the order of the machine are refused") {
    CommandList list = recorded({});
    const auto with_quads = [](const auto& command) { return command->quads.size() > 1; };
    const auto found = std::find_if(list.commands.begin(), list.commands.end(), with_quads);
    REQUIRE(found != list.commands.end());
    auto disordered = std::make_shared<WholeCommand>(**found);
    disordered->quads[1] = disordered->quads[0];
    *found = disordered;
    CHECK_THAT(complaint(file_of(list)), Contains("quads are not in their order"));
}

TEST_CASE("As many accesses of a quad as a file may hold are read, and one more is refused") {
    constexpr std::size_t Most = 1 << 14;
    const auto file_of_one_quad = [](std::size_t accesses) {
        auto whole = std::make_shared<WholeCommand>();
        whole->draw.state = std::make_shared<const Registers>();
        whole->units = {0};
        WorkQuad quad{};
        quad.covered = 1;
        whole->quads.push_back(quad);
        for (std::size_t i = 0; i < accesses; ++i)
            whole->add_access(0, {});
        CommandList list;
        list.commands.push_back(whole);
        return file_of(list);
    };
    const CommandList read = read_back(file_of_one_quad(Most));
    REQUIRE(read.commands.size() == 1);
    CHECK(reads_of(*read.commands[0])[0].size() == Most);
    CHECK_THAT(complaint(file_of_one_quad(Most + 1)), Contains("damaged"));
}

TEST_CASE("Fields are found by name: one that is not known here is passed over") {
    Registers registers;
    registers.fog.density = 0.5f;
    registers.blend.enable = true;
    registers.scissor.width = 77;
    auto whole = std::make_shared<WholeCommand>();
    whole->draw.state = std::make_shared<const Registers>(registers);
    CommandList list;
    list.commands.push_back(whole);
    const std::string bytes = renamed(file_of(list), "fog.density", "fog.dens1ty");
    Registers expected = registers;
    expected.fog.density = Registers{}.fog.density;
    const CommandList read = read_back(bytes);
    REQUIRE(read.commands.size() == 1);
    CHECK(*read.commands[0]->draw.state == expected);
}

void write_to(const std::string& path, const CommandList& list) {
    WorkFileWriter writer(path);
    for (const auto& command : list.commands)
        writer.command(command);
    writer.finish();
}

TEST_CASE("A full disk is told, not passed over") {
    if (!std::ifstream("/dev/full")) return;
    CHECK_THROWS_WITH(write_to("/dev/full", recorded({})),
                      Contains("/dev/full: cannot be written"));
}

TEST_CASE("A disk that is full by the last byte is told") {
    const TemporaryFile file("", ".ffw");
    write_to(file.path(), CommandList{});
    const std::size_t size = content(file.path()).size();
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit{size - 1, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    CHECK_THROWS_WITH(write_to(file.path(), CommandList{}), Contains("cannot be written"));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_DFL);
}

} // namespace
} // namespace ffgpu::work
