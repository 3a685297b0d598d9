// The command stream's reader: walks the words, unpacks payloads, and names the word at fault.

#pragma once

#include "model/base/input_error.h"
#include "model/device/commands.h"

#include <cstdint>
#include <span>
#include <string>

namespace ffgpu {

class CommandReader {
public:
    explicit CommandReader(std::span<const std::uint32_t> words)
        : words_(words) {}

    // Moves to the next command; false at the end.
    bool next() {
        at_ = next_;
        if (at_ == words_.size()) return false;
        const std::size_t count = words_[at_] & 0xffffff;
        if (count > words_.size() - at_ - 1)
            fail("the payload of " + std::to_string(count) + " words is cut off");
        payload_ = words_.subspan(at_ + 1, count);
        next_ = at_ + 1 + count;
        return true;
    }

    unsigned opcode() const { return words_[at_] >> 24; }
    std::span<const std::uint32_t> payload() const { return payload_; }

    template <class Command>
    Command command() const {
        expect(WordCount<Command>);
        return unpack<Command>(payload_);
    }

    void expect(std::size_t words) const {
        if (payload_.size() != words)
            throw InputError("opcode " + std::to_string(opcode()) + " has " +
                             std::to_string(payload_.size()) + " words, expected " +
                             std::to_string(words));
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError("command stream, word " + std::to_string(at_) + ": " + what);
    }

private:
    std::span<const std::uint32_t> words_, payload_;
    std::size_t at_ = 0, next_ = 0;
};

} // namespace ffgpu
