// The text that a capture begins with: read back as it was, and refused in a line where damaged.

#include "model/base/input_error.h"
#include "model/capture/description_text.h"
#include "model/capture/translator.h"

#include <catch2/catch.hpp>

namespace ffgpu::capture {
namespace {

using Catch::Matchers::Contains;

std::string complaint(const std::string& text) {
    try {
        const Translator translator(parse_description(text));
        CommandStream resets;
        translator.add_resets(resets);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST_CASE("A description comes back from its text") {
    const Description contract = describe_contract();
    const std::string text = description_text(contract);
    CHECK(parse_description(text) == contract);
    CHECK_THAT(text, Contains("\nfield mode 0 0 0 2 FogMode 0\n"));
    CHECK_THAT(text, Contains("\nenumeration FogMode Off Linear Exp Exp2\n"));
    CHECK(Translator(contract).is_identity());
}

TEST_CASE("A damaged description is one line that names the line") {
    const std::string good = "enumeration Color Red Green\nregister paint 0 1 1\n"
                             "field color 0 0 0 2 Color 1\nsurface surface 0 1 0\n";
    CHECK(complaint(good).empty());
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return complaint(text);
    };
    CHECK_THAT(with("enumeration", "enumerator"), Contains("line 1: expected enumeration"));
    CHECK_THAT(with("paint 0 1 1", "paint 0 1 1025"), Contains("line 2: expected a number"));
    CHECK_THAT(with("paint 0 1 1", "paint 0 70000 1"), Contains("line 2"));
    CHECK_THAT(with("paint 0 1 1", "paint 0 1"), Contains("line 2: expected more"));
    CHECK_THAT(with("paint 0 1 1", "paint 0 1 0"), Contains("line 3: expected a field within"));
    CHECK_THAT(with("0 0 0 2 Color 1", "0 1 0 2 Color 1"), Contains("field within its register"));
    CHECK_THAT(with("0 0 0 2 Color 1", "0 0 31 2 Color 1"), Contains("line 3"));
    CHECK(with("0 0 0 2 Color 1", "0 0 30 2 Color 1").empty());
    CHECK_THAT(with("0 0 0 2 Color 1", "0 0 0 2 Colour 1"), Contains("expected a type"));
    CHECK_THAT(with("0 0 0 2 Color 1", "0 0 0 2 Color 4"), Contains("line 3"));
    CHECK_THAT(with("0 0 0 2 Color 1", "0 0 0 2 Color"), Contains("line 3: expected more"));
    CHECK_THAT(with("0 0 0 2 Color 1", "0 0 0 2 Color 1 1"), Contains("one reset value"));
    CHECK_THAT(with("0 0 0 2 Color 1", "0 0 0 2 float 1"), Contains("32 bits"));
    CHECK_THAT(with("surface surface 0 1 0\n", ""), Contains("expected a surface"));
    CHECK_THAT(with("register paint 0 1 1\n", ""), Contains("register before its fields"));
    CHECK_THAT(with("paint", "pa\x01nt"), Contains("a name"));
}

TEST_CASE("What a description states twice is refused") {
    const std::string paint = "field color 0 0 0 2 Color 1\n";
    const std::string good = "enumeration Color Red Green\nregister paint 4 2 2\n" + paint +
                             "field gloss 0 0 2 3 unsigned 0\ncommand fill 7 1 1\n" + paint +
                             "surface surface 0 1 1\n" + paint;
    CHECK(complaint(good).empty()); // What is of another register may have the name.
    const auto with = [&](const std::string& before, const std::string& line) {
        std::string text = good;
        text.insert(text.find(before), line + '\n');
        return complaint(text);
    };
    CHECK_THAT(with("field gloss", "field color 0 0 0 2 Color 1"), Contains("line 4: expected"));
    CHECK_THAT(with("field gloss", "field tint 0 0 1 1 unsigned 0"), Contains("bits of its own"));
    CHECK_THAT(with("field gloss", "field color 0 1 0 2 Color 1"), Contains("another name"));
    CHECK(with("field gloss", "field color 1 1 0 2 Color 1").empty());
    CHECK(with("field gloss", "field tint 0 0 5 1 unsigned 0").empty());
    CHECK_THAT(with("field gloss", "field tint 0 0 4 1 unsigned 0"), Contains("found gloss"));
    CHECK_THAT(with("command", "register brush 5 1 1"), Contains("line 5: expected a register of"));
    CHECK(with("command", "register brush 6 1 1").empty());
    CHECK_THAT(with("surface", "command line 7 1 1"), Contains("a command of another opcode"));
    CHECK(with("surface", "command line 8 1 1").empty());
    CHECK_THAT(with("surface", "surface surface 0 1 1"), Contains("expected one surface"));
    CHECK_THAT(with("register", "enumeration Color Red"), Contains("line 2: expected an enum"));
}

TEST_CASE("A description of many large registers is refused before it is made") {
    std::string text;
    for (int i = 0; i < 2; ++i)
        text += "register paint 0 40000 1\n";
    CHECK_THAT(complaint(text), Contains("line 2: expected fewer registers"));
}

TEST_CASE("A description with any byte changed is read or refused in one line") {
    const std::string text = description_text(describe_contract());
    unsigned refused = 0;
    for (std::size_t at = 0; at < text.size(); at += 7) {
        std::string damaged = text;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x15);
        const std::string error = complaint(damaged);
        CHECK(error.find('\n') == std::string::npos);
        refused += !error.empty();
    }
    CHECK(refused > 100);
}

} // namespace
} // namespace ffgpu::capture
