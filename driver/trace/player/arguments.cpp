#include "driver/trace/player/arguments.h"

#include <algorithm>

namespace ffgpu::trace {

const void* Arguments::bytes(const Value& value, std::uint64_t size) {
    switch (value.kind) {
    case ValueKind::Blob: {
        Blob& blob = call_->blob(value);
        blob.pad(size);
        return blob.data();
    }
    case ValueKind::String: {
        Blob& scratch = next_scratch();
        const std::string_view text = call_->text(value);
        scratch.append(reinterpret_cast<const std::byte*>(text.data()), text.size());
        scratch.pad(std::max<std::uint64_t>(size, text.size() + 1));
        return scratch.data();
    }
    case ValueKind::Pointer:
    case ValueKind::Unsigned:
        return offset(value);
    default:
        return nullptr;
    }
}

void* Arguments::output(const Value& value) {
    if (takes_offsets_) return const_cast<void*>(offset(value));
    constexpr std::uint64_t AnyState = 4096; // More than any state that can be asked for.
    Blob& scratch = next_scratch();
    scratch.pad(std::max(AnyState, needed() * sizeof(double)));
    return scratch.data();
}

} // namespace ffgpu::trace
