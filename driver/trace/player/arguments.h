// Arguments: the values of a traced call as the parameters of a GL function, by their C++ types.

#pragma once

#include "driver/gl_types.h"
#include "driver/trace/player/array_sizes.h"
#include "driver/trace/reader/call.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace ffgpu::trace {

class Arguments {
public:
    // Prepares for one call. `array_size`: the command's rule or null. `takes_offsets`: a buffer
    // object is bound where the command looks for one, so that an address is an offset into it.
    // `again`: the call will be played again, in the same way, and by nobody else.
    void begin(Call& call,
               const gl::Context& context,
               ArraySize array_size,
               bool takes_offsets,
               bool again) {
        call_ = &call;
        context_ = &context;
        array_size_ = array_size;
        takes_offsets_ = takes_offsets;
        again_ = again;
        refused_ = false;
        next_scratch_ = 0;
    }

    // The call cannot be made: it would read or write more memory than is sensible.
    bool refused() const { return refused_; }

    template <class Parameter>
    Parameter get(std::size_t index) {
        const Value& value = call_->argument(index);
        if constexpr (!std::is_pointer_v<Parameter>) {
            return to_number<Parameter>(value);
        } else {
            using Pointee = std::remove_pointer_t<Parameter>;
            if constexpr (std::is_same_v<Pointee, const void>) {
                return bytes(value, needed());
            } else if constexpr (std::is_same_v<Pointee, void>) {
                return output(value);
            } else if constexpr (std::is_pointer_v<Pointee>) {
                return pointers<Pointee>(value);
            } else if constexpr (std::is_const_v<Pointee>) {
                return array<std::remove_const_t<Pointee>>(value);
            } else {
                return static_cast<Parameter>(output(value));
            }
        }
    }

private:
    // What a command reads or writes through its pointers, in elements or bytes.
    std::uint64_t needed() {
        const std::uint64_t size = array_size_ ? array_size_(*call_, *context_) : UsualArraySize;
        if (size >= HugeArray) refused_ = true;
        return refused_ ? 0 : size;
    }

    // Bytes as they are: a blob or text, padded to `size`; an offset into a buffer object; or null.
    const void* bytes(const Value& value, std::uint64_t size);

    // Memory for results that nobody looks at.
    void* output(const Value& value);

    // An offset as the pointer that GL takes it for; null where no buffer object is bound.
    const void* offset(const Value& value) const {
        return takes_offsets_
                   ? reinterpret_cast<const void*>(static_cast<std::uintptr_t>(value.bits))
                   : nullptr;
    }

    template <class Element>
    const Element* array(const Value& value) {
        // Bytes are images: null and offsets are legal.
        constexpr bool IsImage = sizeof(Element) == 1;
        if (value.kind == ValueKind::Numbers)
            return static_cast<const Element*>(Call::numbers(value));
        if (value.kind == ValueKind::Blob || value.kind == ValueKind::String)
            return static_cast<const Element*>(bytes(value, needed() * sizeof(Element)));
        if (value.kind == ValueKind::Pointer && takes_offsets_)
            return static_cast<const Element*>(offset(value));
        if (value.is_null() && (IsImage || takes_offsets_)) return nullptr;

        Blob& scratch = next_scratch();
        const auto append = [&](const Value& element) {
            const Element number = to_number<Element>(element);
            scratch.append(reinterpret_cast<const std::byte*>(&number), sizeof number);
        };
        if (value.kind == ValueKind::Array) {
            Call::for_each(value, append);
        } else {
            append(value);
        }
        scratch.pad(needed() * sizeof(Element));
        if (again_ && !refused_ && value.kind == ValueKind::Array &&
            scratch.size() <= Call::room_for_numbers(value))
            call_->become_numbers(value, scratch.bytes());
        return reinterpret_cast<const Element*>(scratch.data());
    }

    // Index arrays of glMultiDrawElements, as long as the longest.
    template <class Pointer>
    Pointer* pointers(const Value& value) {
        Blob& scratch = next_scratch();
        const std::uint64_t longest = longest_index_array(*call_);
        const auto append = [&](const Value& element) {
            const void* const pointer = bytes(element, longest);
            scratch.append(reinterpret_cast<const std::byte*>(&pointer), sizeof pointer);
        };
        if (value.kind == ValueKind::Array) Call::for_each(value, append);
        if (scratch.size() < needed() * sizeof(Pointer)) refused_ = true;
        return reinterpret_cast<Pointer*>(scratch.data());
    }

    Blob& next_scratch() {
        Blob& scratch = scratch_[next_scratch_++ % scratch_.size()];
        scratch.clear();
        return scratch;
    }

    Call* call_ = nullptr;
    const gl::Context* context_ = nullptr;
    ArraySize array_size_ = nullptr;
    bool takes_offsets_ = false;
    bool again_ = false;
    bool refused_ = false;
    std::array<Blob, 4> scratch_; // No command has more arrays.
    std::size_t next_scratch_ = 0;
};

} // namespace ffgpu::trace
