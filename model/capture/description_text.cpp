#include "model/capture/description_text.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace ffgpu::capture {
namespace {

constexpr unsigned MaxWords = 1024;       // of a register or command
constexpr unsigned MaxRegisters = 0xffff; // in all, and the last address
constexpr unsigned MaxOpcode = 0xff;

std::string type_text(const FieldEntry& field) {
    switch (field.type) {
    case FieldEntry::Type::Unsigned:
        return "unsigned";
    case FieldEntry::Type::Signed:
        return "signed";
    case FieldEntry::Type::Float:
        return "float";
    case FieldEntry::Type::Enumeration:
        break;
    }
    return field.enumeration;
}

void append(std::string& text, std::initializer_list<unsigned> numbers) {
    for (const unsigned number : numbers)
        text.append(" ").append(std::to_string(number));
}

void append_packed(std::string& text, const char* kind, const PackedEntry& packed) {
    text.append(kind).append(" ").append(packed.name);
    append(text, {packed.address, packed.count, packed.words});
    text += '\n';
    for (const FieldEntry& field : packed.fields) {
        text.append("field ").append(field.name);
        append(text, {field.index, field.word, field.lsb, field.width});
        text.append(" ").append(type_text(field));
        for (const std::uint32_t reset : field.resets) {
            char hex[16];
            std::snprintf(hex, sizeof hex, " %x", reset);
            text += hex;
        }
        text += '\n';
    }
}

class Parser {
public:
    explicit Parser(std::string_view text)
        : text_(text) {}

    Description parse() {
        while (!text_.empty()) {
            ++line_;
            split_line();
            parse_line();
        }
        if (result_.surface.name.empty()) fail("a surface", "the end");
        return std::move(result_);
    }

private:
    using Words = std::vector<std::string_view>;

    void split_line() {
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        std::string_view line = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        words_.clear();
        while (!line.empty()) {
            const std::size_t length = std::min(line.find(' '), line.size());
            words_.push_back(line.substr(0, length));
            line.remove_prefix(std::min(length + 1, line.size()));
        }
    }

    void parse_line() {
        const std::string_view kind = word(0);
        if (kind == "enumeration") return parse_enumeration();
        if (kind == "field") return parse_field();
        if (kind == "register") {
            begin_packed(result_.registers.emplace_back(parse_packed(MaxRegisters)));
            register_count_ += packed_->count;
            if (register_count_ > MaxRegisters) fail("fewer registers", "more");
            take_addresses(registers_seen_, "a register of another address");
        } else if (kind == "command") {
            begin_packed(result_.commands.emplace_back(parse_packed(MaxOpcode)));
            take_addresses(commands_seen_, "a command of another opcode");
        } else if (kind == "surface") {
            if (!result_.surface.name.empty()) fail("one surface", "another");
            result_.surface = parse_packed(0);
            begin_packed(result_.surface);
        } else {
            fail("enumeration, register, command, surface or field", kind);
        }
    }

    // The fields that follow are its.
    void begin_packed(PackedEntry& packed) {
        packed_ = &packed;
        bits_seen_.assign(packed.words, 0);
        elements_seen_.clear();
    }

    void take_addresses(std::vector<bool>& seen, const char* expected) const {
        for (unsigned i = 0; i < packed_->count; ++i) {
            if (seen[packed_->address + i]) fail(expected, packed_->name);
            seen[packed_->address + i] = true;
        }
    }

    // A bit belongs to one field, and a field of one name and index stands once.
    void take_field(const FieldEntry& field) {
        const std::uint32_t bits = field_mask(field.width) << field.lsb;
        for (unsigned i = 0; i < field.elements(); ++i) {
            std::uint32_t& seen = bits_seen_[field.word + i];
            if ((seen & bits) != 0) fail("a field of bits of its own", field.name);
            seen |= bits;
            if (!elements_seen_.emplace(field.name, field.index + i).second)
                fail("a field of another name or index", field.name);
        }
    }

    static std::uint32_t field_mask(unsigned width) {
        return std::numeric_limits<std::uint32_t>::max() >> (32 - width);
    }

    void parse_enumeration() {
        EnumerationEntry entry{name(1), {}};
        if (!enumerations_seen_.insert(entry.name).second)
            fail("an enumeration of another name", entry.name);
        for (std::size_t i = 2; i < words_.size(); ++i)
            entry.values.push_back(name(i));
        result_.enumerations.push_back(std::move(entry));
    }

    PackedEntry parse_packed(unsigned most) {
        PackedEntry entry;
        entry.name = name(1);
        entry.address = number(2, 0, most);
        entry.count = number(3, 1, most - entry.address + 1);
        entry.words = number(4, 0, MaxWords);
        return entry;
    }

    void parse_field() {
        if (!packed_) fail("a register before its fields", "a field");
        FieldEntry field;
        field.name = name(1);
        field.index = number(2, 0, 32 * MaxWords);
        field.word = number(3, 0, MaxWords);
        field.lsb = number(4, 0, 31);
        field.width = number(5, 1, 32 - field.lsb);
        parse_type(field);
        for (std::size_t i = 7; i < words_.size(); ++i)
            field.resets.push_back(number(i, 0, field_mask(field.width), 16));
        if (field.resets.empty()) word(7);
        if (field.elements() > 1 && field.width != 32) fail("one reset value", "more");
        if (field.word + field.elements() > packed_->words)
            fail("a field within its register", field.name);
        take_field(field);
        packed_->fields.push_back(std::move(field));
    }

    void parse_type(FieldEntry& field) {
        const std::string type = name(6);
        field.type = FieldEntry::Type::Enumeration;
        if (type == "unsigned") field.type = FieldEntry::Type::Unsigned;
        if (type == "signed") field.type = FieldEntry::Type::Signed;
        if (type == "float") field.type = FieldEntry::Type::Float;
        if (field.type == FieldEntry::Type::Float && field.width != 32) fail("32 bits", "fewer");
        if (field.type != FieldEntry::Type::Enumeration) return;
        if (!find_enumeration(result_, type)) fail("a type", type);
        field.enumeration = type;
    }

    std::string_view word(std::size_t i) const {
        if (i >= words_.size()) fail("more", "the line's end");
        return words_[i];
    }

    // Of the characters of names: what is printed of them in an error is one line.
    std::string name(std::size_t i) const {
        for (const char c : word(i)) {
            const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                              (c >= '0' && c <= '9') || c == '_';
            if (!good) fail("a name", "another character");
        }
        if (word(i).empty() || word(i).size() > 64) fail("a name of 1 to 64 letters", "another");
        return std::string(word(i));
    }

    std::uint32_t
    number(std::size_t i, std::uint32_t least, std::uint32_t most, int base = 10) const {
        const std::string_view text = word(i);
        std::uint32_t value = 0;
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), value, base);
        if (error != std::errc{} || end != text.data() + text.size() || value < least ||
            value > most)
            fail("a number from " + std::to_string(least) + " to " + std::to_string(most),
                 "another");
        return value;
    }

    [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
        std::string shown(found.substr(0, 64));
        for (char& c : shown)
            if (c < ' ' || c > '~') c = '?';
        throw InputError("description, line " + std::to_string(line_) + ": expected " + expected +
                         ", found " + shown);
    }

    std::string_view text_;
    unsigned line_ = 0;
    Words words_;
    Description result_;
    unsigned register_count_ = 0;
    PackedEntry* packed_ = nullptr; // whose fields follow

    // What no second line may state.
    std::set<std::string> enumerations_seen_;
    std::vector<bool> registers_seen_ = std::vector<bool>(MaxRegisters + 1);
    std::vector<bool> commands_seen_ = std::vector<bool>(MaxOpcode + 1);
    std::vector<std::uint32_t> bits_seen_;                     // of *packed_, a word each
    std::set<std::pair<std::string, unsigned>> elements_seen_; // of *packed_: name and index
};

} // namespace

std::string description_text(const Description& description) {
    std::string text;
    for (const EnumerationEntry& entry : description.enumerations) {
        text.append("enumeration ").append(entry.name);
        for (const std::string& value : entry.values)
            text.append(" ").append(value);
        text += '\n';
    }
    for (const PackedEntry& reg : description.registers)
        append_packed(text, "register", reg);
    for (const PackedEntry& command : description.commands)
        append_packed(text, "command", command);
    append_packed(text, "surface", description.surface);
    return text;
}

Description parse_description(std::string_view text) {
    return Parser(text).parse();
}

} // namespace ffgpu::capture
