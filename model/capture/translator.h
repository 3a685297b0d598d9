// Translator: commands of another release's contract as this release's, by the names of registers,
// fields and enumerators.
//
// What this release does not have is left out where it holds its reset value, and is an InputError
// that names it where it does not. What the other release did not have keeps its reset value.

#pragma once

#include "model/device/command_reader.h"
#include "model/device/description.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ffgpu::capture {

// The words of one kind of register or command.
class PackedTranslation {
public:
    // to null: this release has none of that name.
    PackedTranslation(const Description& from,
                      const PackedEntry& from_entry,
                      const Description& to,
                      const PackedEntry* to_entry);

    std::size_t words() const { return words_; } // before translation

    // Appends the translated words.
    void translate(std::span<const std::uint32_t> words, std::vector<std::uint32_t>& out) const;

    // Of what this release does not have: throws where a field does not hold its reset value.
    void expect_reset(std::span<const std::uint32_t> words) const;

private:
    struct Field {
        std::string name; // as an error names it
        FieldEntry::Type type = FieldEntry::Type::Unsigned;
        unsigned word = 0, lsb = 0, width = 0;
        std::uint32_t reset = 0;
        unsigned to_word = 0, to_lsb = 0;
        unsigned to_width = 0;                // 0: this release does not have the field
        std::vector<std::string> value_names; // of an enumeration
        std::vector<std::optional<std::uint32_t>> to_values; // of the same
    };

    void place(Field& field, const PackedEntry& to, const FieldEntry& from, unsigned index);
    static std::uint32_t convert(const Field& field, std::uint32_t value);
    [[noreturn]] static void fail_unknown(const Field& field, std::uint32_t value);

    std::size_t words_;
    std::vector<Field> fields_;
    std::vector<std::uint32_t> reset_; // this release's
};

class Translator {
public:
    explicit Translator(const Description& from);

    // The contract is this release's: nothing needs to be translated.
    bool is_identity() const { return identity_; }

    // Writes of the registers whose reset values are not this release's.
    void add_resets(CommandStream& commands) const;

    // Appends the reader's command; throws InputError.
    void add(const CommandReader& reader, CommandStream& commands) const;

    std::size_t surface_words() const { return surface_.words(); }
    Surface surface(std::span<const std::uint32_t> words) const;

private:
    struct RegisterPlace {
        std::size_t packed = 0;               // in packed_
        std::optional<std::uint32_t> address; // of this release
    };
    struct CommandPlace {
        std::size_t packed = 0;
        std::string name;
        std::optional<Opcode> opcode;
    };

    Translator(const Description& from, const Description& to);
    void add_register(const RegisterPlace& place,
                      std::span<const std::uint32_t> words,
                      CommandStream& commands) const;

    bool identity_;
    std::vector<PackedTranslation> packed_;
    std::map<std::uint32_t, RegisterPlace> registers_; // by the other's addresses
    std::map<std::uint32_t, CommandPlace> commands_;   // by the other's opcodes
    std::vector<std::vector<std::uint32_t>> resets_;   // the other's, one an element of packed_
    PackedTranslation surface_;
};

} // namespace ffgpu::capture
