// A capture that was made under another list of registers draws the same picture.
//
// The other contract is this one's description, changed; the file's words are packed here, field by
// field by name, and share no code with the translator.

#include "model/base/input_error.h"
#include "model/capture/capture_reader.h"
#include "model/capture/capture_writer.h"
#include "tests/gpu/scene.h"
#include "tests/support/temporary_file.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <catch2/catch.hpp>

namespace ffgpu::capture {
namespace {

using Catch::Matchers::Contains;

PackedEntry& find(std::vector<PackedEntry>& all, const std::string& name) {
    return *std::ranges::find(all, name, &PackedEntry::name);
}

FieldEntry& field_of(PackedEntry& packed, const std::string& name) {
    return *std::ranges::find(packed.fields, name, &FieldEntry::name);
}

std::uint32_t bits_at(std::span<const std::uint32_t> words, const FieldEntry& field, unsigned i) {
    return words[field.word + i] >> field.lsb & (~std::uint32_t{0} >> (32 - field.width));
}

// Everything there is, at other places.
Description shuffled_contract() {
    Description other = describe_contract();
    // Other numbers: enumerators in the other order, registers from the last to the first.
    for (EnumerationEntry& entry : other.enumerations)
        std::ranges::reverse(entry.values);
    unsigned address = 3;
    for (std::size_t i = other.registers.size(); i-- > 0;) {
        other.registers[i].address = address;
        address += other.registers[i].count;
    }
    for (PackedEntry& command : other.commands)
        command.address += 20;
    // Fields from the last to the first, each in a word of its own.
    const auto spread = [&](PackedEntry& packed) {
        std::ranges::reverse(packed.fields);
        packed.words = 0;
        for (FieldEntry& field : packed.fields) {
            field.word = packed.words;
            if (field.width < 32) field.lsb = 1;
            packed.words += field.elements();
        }
    };
    std::ranges::for_each(other.registers, spread);
    std::ranges::for_each(other.commands, spread);
    spread(other.surface);
    return other;
}

// Packs by an entry of the other contract what `words` hold under this release's of that name.
// Enumerators go by their names.
std::vector<std::uint32_t> repack(std::span<const std::uint32_t> words,
                                  const PackedEntry& ours,
                                  const Description& other,
                                  const PackedEntry& theirs) {
    const Description contract = describe_contract();
    std::vector<std::uint32_t> packed = reset_words(theirs);
    for (const FieldEntry& to : theirs.fields)
        for (const FieldEntry& from : ours.fields) {
            if (to.name != from.name || to.index != from.index) continue;
            for (unsigned i = 0; i < to.elements(); ++i) {
                std::uint32_t value = bits_at(words, from, i);
                if (from.type == FieldEntry::Type::Enumeration) {
                    const auto& name = find_enumeration(contract, from.enumeration)->values[value];
                    const auto& values = find_enumeration(other, to.enumeration)->values;
                    value = static_cast<std::uint32_t>(std::ranges::find(values, name) -
                                                       values.begin());
                }
                const std::uint32_t mask = ~std::uint32_t{0} >> (32 - to.width);
                std::uint32_t& word = packed[to.word + i];
                word = (word & ~(mask << to.lsb)) | (value & mask) << to.lsb;
            }
        }
    return packed;
}

// Resets of enumerations follow their names as well.
void renumber_resets(Description& other) {
    const Description contract = describe_contract();
    const auto renumber = [&](PackedEntry& packed) {
        for (FieldEntry& field : packed.fields) {
            if (field.type != FieldEntry::Type::Enumeration) continue;
            const auto& names = find_enumeration(contract, field.enumeration)->values;
            const auto& values = find_enumeration(other, field.enumeration)->values;
            field.resets[0] = static_cast<std::uint32_t>(
                std::ranges::find(values, names[field.resets[0]]) - values.begin());
        }
    };
    std::ranges::for_each(other.registers, renumber);
    std::ranges::for_each(other.commands, renumber);
    renumber(other.surface);
}

// A Device that writes a capture under the other contract.
class OtherRecorder : public Device {
public:
    OtherRecorder(const std::string& path, const Description& other, std::uint64_t memory)
        : other_(other)
        , file_(path)
        , memory_(memory) {
        write_beginning(file_, {.version = OldestVersion, .memory_bytes = memory}, other);
    }

    std::uint64_t memory_size() const override { return memory_; }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        begin(Record::WriteMemory);
        file_.put_u32(at);
        file_.put_u32(static_cast<std::uint32_t>(bytes.size()));
        file_.put_bytes(bytes.data(), bytes.size());
    }
    void read_memory(DeviceAddress, std::span<std::byte>) override {}
    void submit(const CommandStream& commands) override {
        std::vector<std::uint32_t> words;
        for_each_command(commands.words, [&](const CommandReader& reader) { add(reader, words); });
        submit_words(words);
    }
    void finish() override {}
    std::vector<const StatisticsGroup*> statistics() const override { return {}; }

    void submit_words(const std::vector<std::uint32_t>& words) {
        begin(Record::Submit);
        file_.put_u32(static_cast<std::uint32_t>(words.size()));
        file_.put_bytes(words.data(), 4 * words.size());
    }

    void shown(const Surface& picture) {
        std::array<std::uint32_t, WordCount<Surface>> words{};
        pack(picture, words);
        const auto theirs = repack(words, contract_.surface, other_, other_.surface);
        begin(Record::Shown);
        file_.put_u32(0);
        file_.put_bytes(theirs.data(), 4 * theirs.size());
    }

    void end() { file_.end(); }

private:
    void begin(Record record) {
        const auto kind = static_cast<std::uint8_t>(record);
        file_.put_bytes(&kind, 1);
    }

    void add(const CommandReader& reader, std::vector<std::uint32_t>& words) {
        std::span<const std::uint32_t> payload = reader.payload();
        unsigned address = static_cast<unsigned>(reader.opcode());
        const bool is_register = reader.opcode() == Opcode::WriteRegister;
        if (is_register) {
            address = payload[0];
            payload = payload.subspan(1);
        }
        auto& entries = is_register ? contract_.registers : contract_.commands;
        const auto ours = std::ranges::find_if(entries, [&](const PackedEntry& entry) {
            return address >= entry.address && address - entry.address < entry.count;
        });
        auto& others = is_register ? other_.registers : other_.commands;
        const auto theirs = std::ranges::find(others, ours->name, &PackedEntry::name);
        if (theirs == others.end()) return; // The other release has none.
        const auto packed = repack(payload, *ours, other_, *theirs);
        const unsigned place = theirs->address + address - ours->address;
        const auto count = static_cast<std::uint32_t>(packed.size());
        words.push_back(is_register ? 1u << 24 | (1 + count) : place << 24 | count);
        if (is_register) words.push_back(place);
        words.insert(words.end(), packed.begin(), packed.end());
    }

    Description contract_ = describe_contract();
    Description other_;
    ChunkWriter file_;
    std::uint64_t memory_;
};

constexpr std::uint64_t MemoryBytes = std::uint64_t{32} << 20;
constexpr Surface Picture{
    .address = test::ColorAt, .format = Format::Rgba8, .width = 32, .height = 32, .stride = 128};

// A blended, fogged and textured triangle over a clear, said to any device.
void draw_scene(Device& device) {
    const std::vector<test::Vertex> vertices{{-1, -1, 0.5f, 1, 1, 0, 0, 1, 0, 0},
                                             {1, -1, 0.25f, 1, 0, 1, 0, 0.5f, 2, 0},
                                             {0, 1, -0.5f, 1, 0, 0, 1, 0.75f, 1, 2}};
    const std::vector<std::uint32_t> texels{0xff00ff00, 0xffff00ff, 0xff808080, 0x80ffffff};
    device.write_memory(test::VerticesAt, test::bytes_of(vertices));
    device.write_memory(test::TextureAt, test::bytes_of(texels));
    Registers r;
    r.targets.color[0] = Picture;
    r.targets.depth = {test::DepthAt, Format::Depth24Stencil8, 32, 32, 128};
    r.scissor = {0, 0, 32, 32};
    r.viewport.width = r.viewport.height = 32;
    r.vertex_format.stride = 10;
    r.vertex_format.elements[static_cast<unsigned>(Attribute::Color)] = {4, 4};
    r.vertex_format.elements[static_cast<unsigned>(Attribute::TexCoord0)] = {2, 8};
    r.images[0] = {{TextureKind::TwoD, Format::Rgba8, 2, 2}, test::TextureAt};
    r.samplers[0].bias = -5;
    r.samplers[0].mip_filter = MipFilter::None;
    r.samplers[0].wrap = {Wrap::MirroredRepeat, Wrap::ClampToEdge, Wrap::Repeat};
    r.combiners[0].enable = true;
    r.combiners[0].rgb.op = CombineOp::Modulate;
    r.combiners[0].rgb.arguments[1].source = CombineSource::Texture0;
    r.fog.mode = FogMode::Exp;
    r.fog.color = 0x4080c0;
    r.blend.enable = true;
    r.blend.rgb_source = BlendFactor::SourceAlpha;
    r.blend.rgb_destination = BlendFactor::OneMinusSourceAlpha;
    r.depth.test_enable = r.depth.write_enable = true;
    CommandStream stream;
    write_changes(Registers{}, r, stream);
    stream.add(ClearCommand{
        .color = true, .depth = true, .color_value = 0xff332211, .depth_value = 0xffffff});
    stream.add(DrawCommand{.count = 3, .vertex_count = 3, .vertex_address = test::VerticesAt});
    stream.add(DrawImageCommand{.format = Format::Bitmap,
                                .address = test::VerticesAt,
                                .stride = 1,
                                .width = 8,
                                .height = 8,
                                .x = 3,
                                .y = 5});
    stream.add(Opcode::EndFrame);
    device.submit(stream);
}

std::vector<std::uint32_t> read_picture(Device& device) {
    std::vector<std::uint32_t> pixels(32 * 32);
    device.read_memory(test::ColorAt, std::as_writable_bytes(std::span(pixels)));
    return pixels;
}

std::vector<std::uint32_t> drawn_directly() {
    FunctionalGpu gpu({.memory_bytes = MemoryBytes});
    draw_scene(gpu);
    return read_picture(gpu);
}

using Extra = std::function<void(OtherRecorder&)>;

std::vector<std::uint32_t> drawn_from(const Description& other, const Extra& extra = {}) {
    const TemporaryFile file("", ".ffc");
    OtherRecorder recorder(file.path(), other, MemoryBytes);
    draw_scene(recorder);
    if (extra) extra(recorder);
    recorder.shown(Picture);
    recorder.end();
    FunctionalGpu gpu({.memory_bytes = MemoryBytes});
    CaptureReader reader(file.path());
    const auto shown = reader.play_frame(gpu);
    REQUIRE(shown);
    CHECK(shown->picture == Picture);
    return read_picture(gpu);
}

std::string complaint(const Description& other, const Extra& extra = {}) {
    try {
        drawn_from(other, extra);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST_CASE("A capture with every register, field and enumerator elsewhere draws the same picture") {
    Description other = shuffled_contract();
    renumber_resets(other);
    REQUIRE(other.registers.front().address > other.registers.back().address);
    CHECK(drawn_from(other) == drawn_directly());
}

TEST_CASE("A capture from before a register, a field and an enumerator were added draws the same") {
    Description other = describe_contract();
    std::erase_if(other.registers,
                  [](const PackedEntry& reg) { return reg.name == "multisample"; });
    std::erase_if(find(other.registers, "fog").fields,
                  [](const FieldEntry& field) { return field.name == "start"; });
    for (EnumerationEntry& entry : other.enumerations)
        if (entry.name == "CombineOp") entry.values.resize(9);
    CHECK(drawn_from(other) == drawn_directly());
}

TEST_CASE("A capture with narrower fields draws the same picture") {
    Description other = describe_contract();
    field_of(find(other.registers, "sampler"), "bias").width = 4;           // -5: signed
    field_of(find(other.registers, "texture_image"), "width").width = 4;    // 2
    field_of(find(other.registers, "blend"), "rgb_source").width = 3;       // 6
    field_of(find(other.registers, "sampler"), "max_anisotropy").width = 1; // 1
    CHECK(drawn_from(other) == drawn_directly());
}

TEST_CASE("A reset value of another release is that of its captures") {
    Description other = describe_contract();
    field_of(find(other.registers, "fragment_control"), "alpha_test").resets = {1};
    FieldEntry& compare = field_of(find(other.registers, "fragment_control"), "alpha_compare");
    compare.resets = {0}; // Never
    const auto picture = drawn_from(other);
    CHECK(std::ranges::count(picture, 0xff332211) == 32 * 32); // The clear alone.
    CHECK(drawn_directly() != picture);
}

// A write of the register at reset, but for one field.
Extra write_field(Description contract,
                  const std::string& name,
                  const std::string& field_name,
                  std::uint32_t value) {
    PackedEntry& reg = find(contract.registers, name);
    field_of(reg, field_name).resets = {value};
    std::vector<std::uint32_t> words = reset_words(reg);
    words.insert(words.begin(), {1u << 24 | (1 + reg.words), reg.address});
    return [words](OtherRecorder& recorder) { recorder.submit_words(words); };
}

// The newer release: fog_volume, and a field of fog.
Description newer_contract() {
    Description other = describe_contract();
    other.registers.push_back({"fog_volume",
                               200,
                               1,
                               1,
                               {{.name = "depth", .enumeration = {}, .width = 8, .resets = {9}}}});
    PackedEntry& fog = find(other.registers, "fog");
    fog.fields.push_back(
        {.name = "height", .enumeration = {}, .word = fog.words++, .width = 8, .resets = {4}});
    for (EnumerationEntry& entry : other.enumerations)
        if (entry.name == "LogicOp") entry.values.insert(entry.values.begin() + 3, "Swap");
    field_of(find(other.registers, "blend"), "logic_op").resets = {4}; // Copy
    other.commands.push_back({"flood", 77, 1, 0, {}});
    return other;
}

TEST_CASE("What a newer release has is left out at its reset value and named at another") {
    const Description other = newer_contract();
    const auto writes = [](std::uint32_t depth) {
        return [depth](OtherRecorder& recorder) {
            recorder.submit_words({1u << 24 | 2, 200, depth});
        };
    };
    CHECK(drawn_from(other, writes(9)) == drawn_directly());
    CHECK_THAT(complaint(other, writes(8)),
               Contains("fog_volume.depth holds 8") && Contains("chunk at byte") &&
                   Contains("command stream, word 0"));
    CHECK_THAT(
        complaint(other, [](OtherRecorder& recorder) { recorder.submit_words({77u << 24}); }),
        Contains("no command flood"));

    CHECK(complaint(other, write_field(other, "fog", "height", 4)).empty());
    CHECK_THAT(complaint(other, write_field(other, "fog", "height", 5)),
               Contains("fog.height holds 5"));
    CHECK(complaint(other, write_field(other, "blend", "logic_op", 4)).empty());
    CHECK_THAT(complaint(other, write_field(other, "blend", "logic_op", 3)),
               Contains("blend.logic_op holds Swap"));
}

TEST_CASE("A value that a narrower field of this release cannot hold is named") {
    Description other = describe_contract();
    FieldEntry& factor = field_of(find(other.registers, "primitive_setup"), "line_stipple_factor");
    factor.width = 12;
    const auto set = [&](std::uint32_t value) {
        return write_field(other, "primitive_setup", "line_stipple_factor", value);
    };
    CHECK(factor.lsb + factor.width <= 32);
    CHECK(complaint(other, set(256)).empty());
    CHECK_THAT(complaint(other, set(512)),
               Contains("primitive_setup.line_stipple_factor holds 512"));
}

} // namespace
} // namespace ffgpu::capture
