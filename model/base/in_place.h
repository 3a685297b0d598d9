// Values made where they lie. Assigned, a value is made beside its place and copied from there, in
// parts that are wider than those that were written a moment before: one_store.h says what that
// costs.

#pragma once

#include <new>
#include <type_traits>

namespace ffgpu {

template <class Value, class Make>
void make_in_place(Value& at, Make&& make) {
    static_assert(std::is_trivially_destructible_v<Value>);
    ::new (static_cast<void*>(&at)) Value(make());
}

} // namespace ffgpu
