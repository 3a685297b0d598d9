// The byte stream of a display list: records one after the other, each a header and its arguments.
// A value lies at its natural alignment. An array is its length in bytes, then, at a multiple of
// eight, its bytes.

#pragma once

#include "driver/commands/command.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace ffgpu::gl {

// What a record does: a Command, or one of these.
enum class Operation : std::uint16_t {
    SetAttribute = static_cast<std::uint16_t>(Command::Count), // attribute, components, four values
    SetColorIndex,                                             // value
    Vertex,    // components, four values: outside of a glBegin/glEnd of this list
    DrawBlock, // pointer to the VertexBlock
    Count
};

constexpr Operation operation(Command command) {
    return static_cast<Operation>(command);
}

struct RecordHeader {
    Operation operation;
    std::uint32_t bytes; // of the whole record, a multiple of eight
};

constexpr std::uint64_t NullArray = ~std::uint64_t{0};

class RecordWriter {
public:
    RecordWriter(std::vector<std::byte>& code, Operation operation)
        : code_(code)
        , start_(code.size())
        , operation_(operation) {
        code_.resize(start_ + sizeof(RecordHeader));
    }
    RecordWriter(const RecordWriter&) = delete;
    RecordWriter& operator=(const RecordWriter&) = delete;
    ~RecordWriter() { code_.resize(committed_ ? code_.size() : start_); }

    template <class T>
    RecordWriter& value(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        std::memcpy(extend(sizeof(T), alignof(T)), &value, sizeof(T));
        return *this;
    }

    // Room for `bytes`, to be filled before the next call. `present` false: a null pointer.
    std::byte* array(std::size_t bytes, bool present = true) {
        value(present ? std::uint64_t{bytes} : NullArray);
        return extend(present ? bytes : 0, 8);
    }

    // A record that is not committed (an exception) leaves no trace.
    void commit() {
        extend(0, 8);
        const RecordHeader header{operation_, static_cast<std::uint32_t>(code_.size() - start_)};
        std::memcpy(code_.data() + start_, &header, sizeof(header));
        committed_ = true;
    }

private:
    std::byte* extend(std::size_t bytes, std::size_t alignment) {
        const std::size_t at = (code_.size() + alignment - 1) / alignment * alignment;
        code_.resize(at + bytes);
        return code_.data() + at;
    }

    std::vector<std::byte>& code_;
    std::size_t start_;
    Operation operation_;
    bool committed_ = false;
};

class RecordReader {
public:
    // `record`: the header's place, a multiple of eight.
    explicit RecordReader(const std::byte* record)
        : at_(record + sizeof(RecordHeader))
        , record_(record) {}

    template <class T>
    T read() {
        if constexpr (std::is_pointer_v<T>) {
            return static_cast<T>(static_cast<const void*>(array()));
        } else {
            align(alignof(T));
            T value;
            std::memcpy(&value, at_, sizeof(T));
            at_ += sizeof(T);
            return value;
        }
    }

private:
    const std::byte* array() {
        const auto bytes = read<std::uint64_t>();
        if (bytes == NullArray) return nullptr;
        align(8);
        const std::byte* const data = at_;
        at_ += bytes;
        return data;
    }
    void align(std::size_t alignment) {
        const auto offset = static_cast<std::size_t>(at_ - record_);
        at_ = record_ + (offset + alignment - 1) / alignment * alignment;
    }

    const std::byte* at_;
    const std::byte* record_;
};

} // namespace ffgpu::gl
