// Call: one call of the traced program, with all its arguments and its result.

#pragma once

#include "driver/trace/reader/blob.h"
#include "driver/trace/reader/value.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::trace {

// A traced function. One object a function, alive as long as the reader.
struct Signature {
    std::uint32_t id = 0; // Small, and unique among the functions of a trace.
    std::string name;
    std::vector<std::string> arguments;
};

class Call {
public:
    std::uint64_t number() const { return number_; }
    std::uint32_t thread() const { return thread_; }
    const Signature& signature() const { return *signature_; }
    std::string_view name() const { return signature_->name; }

    // Not made by the program but by the tracer: the vertex arrays that lie in the program's
    // memory, and the size of a window. To be played like any other.
    bool is_fake() const { return (flags_ & 1) != 0; }

    // Argument `index`; Null where the trace has none.
    const Value& argument(std::size_t index) const {
        if (index < in_order_) [[likely]]
            return values_[index];
        return index < argument_at_.size() && argument_at_[index] != None
                   ? values_[argument_at_[index]]
                   : NoValue;
    }
    // The argument of that name; Null where there is none.
    const Value& argument(std::string_view name) const {
        for (std::size_t i = 0; i < signature_->arguments.size(); ++i)
            if (signature_->arguments[i] == name) return argument(i);
        return NoValue;
    }
    std::size_t argument_count() const { return signature_->arguments.size(); }
    const Value& result() const { return result_at_ == None ? NoValue : values_[result_at_]; }

    std::string_view text(const Value& string) const {
        return std::string_view(text_).substr(string.bits >> 32,
                                              static_cast<std::uint32_t>(string.bits));
    }
    // The caller may swap() the blob away.
    Blob& blob(const Value& blob) { return *blobs_[blob.bits]; }
    const Blob& blob(const Value& blob) const { return *blobs_[blob.bits]; }

    // An array becomes Numbers, which take no more room than its elements did: the call is to be
    // played again, and nobody asks for its elements.
    void become_numbers(const Value& array, std::span<const std::byte> numbers) {
        Value& value = values_[static_cast<std::size_t>(&array - values_.data())];
        std::memcpy(&value + 1, numbers.data(), numbers.size());
        value.kind = ValueKind::Numbers;
        value.bits = numbers.size();
    }
    static const void* numbers(const Value& value) { return &value + 1; }
    static std::size_t room_for_numbers(const Value& array) {
        return (array.extent - 1) * sizeof(Value);
    }

    // Brings it into the processor's caches, for whoever plays it soon: first itself, then its
    // values.
    void prefetch() const {
        __builtin_prefetch(this);
        __builtin_prefetch(reinterpret_cast<const std::byte*>(this) + 64);
    }
    void prefetch_values() const { __builtin_prefetch(values_.data()); }

    // Calls visit(element) for each element of an array or struct.
    template <class Visit>
    static void for_each(const Value& parent, Visit&& visit) {
        const Value* element = &parent + 1;
        for (std::uint32_t i = 0; i < parent.count(); ++i, element += element->extent)
            visit(*element);
    }

private:
    friend class TraceReader;
    friend class ValueParser;

    static constexpr std::uint32_t None = ~std::uint32_t{0};
    static constexpr Value NoValue{};

    void reset(const Signature& signature, std::uint64_t number, std::uint32_t thread) {
        signature_ = &signature;
        number_ = number;
        thread_ = thread;
        flags_ = 0;
        values_.clear();
        text_.clear();
        blob_count_ = 0;
        in_order_ = 0;
        argument_at_.assign(signature.arguments.size(), None);
        result_at_ = None;
    }

    const Signature* signature_ = nullptr;
    std::uint64_t number_ = 0;
    std::uint32_t thread_ = 0;
    std::uint32_t flags_ = 0;
    std::uint32_t result_at_ = None;
    // So many arguments, the first ones, are values_ of their own indices: numbers behind each
    // other, as most calls have them.
    std::uint32_t in_order_ = 0;
    std::vector<std::uint32_t> argument_at_; // index into values_
    std::vector<Value> values_;
    std::string text_;
    // The first blob_count_ are of this call, the others are spare.
    std::vector<std::unique_ptr<Blob>> blobs_;
    std::size_t blob_count_ = 0;
};

} // namespace ffgpu::trace
