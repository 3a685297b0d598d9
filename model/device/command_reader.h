// The command stream's reader: walks the words, unpacks payloads, and names the word at fault.

#pragma once

#include "model/base/input_error.h"
#include "model/device/commands.h"
#include "model/device/registers.h"

#include <cstdint>
#include <span>
#include <string>

namespace ffgpu {

class CommandReader {
public:
    explicit CommandReader(std::span<const std::uint32_t> words)
        : words_(words) {}

    // Moves to the next command; false at the end. Throws InputError, as do the others, in a
    // stream that is damaged.
    bool next() {
        at_ = next_;
        if (at_ == words_.size()) return false;
        const std::size_t count = CommandStream::payload_words(words_[at_]);
        if (count > words_.size() - at_ - 1)
            fail("the payload of " + std::to_string(count) + " words is cut off");
        payload_ = words_.subspan(at_ + 1, count);
        next_ = at_ + 1 + count;
        return true;
    }

    // May be none of the enumeration.
    Opcode opcode() const { return CommandStream::opcode(words_[at_]); }
    std::span<const std::uint32_t> payload() const { return payload_; }

    // Header and payload.
    std::span<const std::uint32_t> whole() const { return words_.subspan(at_, next_ - at_); }

    template <class Command>
    Command command() const {
        expect(WordCount<Command>);
        return unpack<Command>(payload_);
    }

    struct RegisterWrite {
        std::uint32_t address; // of a register that there is
        std::span<const std::uint32_t> words;
    };
    RegisterWrite register_write() const {
        if (payload_.empty()) throw InputError("a register write without an address");
        const std::uint32_t address = payload_[0];
        if (address >= RegisterCount)
            throw InputError("there is no register " + std::to_string(address));
        expect(std::size_t{1} + RegisterWords[address]);
        return {address, payload_.subspan(1)};
    }

    void expect(std::size_t words) const {
        if (payload_.size() != words)
            throw InputError("opcode " + std::to_string(static_cast<unsigned>(opcode())) + " has " +
                             std::to_string(payload_.size()) + " words, expected " +
                             std::to_string(words));
    }

    [[noreturn]] void unknown_opcode() const {
        throw InputError("there is no opcode " + std::to_string(static_cast<unsigned>(opcode())));
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError("command stream, word " + std::to_string(at_) + ": " + what);
    }

private:
    std::span<const std::uint32_t> words_, payload_;
    std::size_t at_ = 0, next_ = 0;
};

// Calls visit(reader) at each command. An InputError that it throws is thrown on with the word of
// the command.
template <class Visit>
void for_each_command(std::span<const std::uint32_t> words, Visit&& visit) {
    CommandReader reader(words);
    while (reader.next()) {
        try {
            visit(static_cast<const CommandReader&>(reader));
        } catch (const InputError& error) {
            reader.fail(error.what());
        }
    }
}

} // namespace ffgpu
