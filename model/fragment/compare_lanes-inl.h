// compare() of compare.h on vectors of signed lanes.

#if defined(FFGPU_FRAGMENT_COMPARE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_FRAGMENT_COMPARE_LANES_INL_H_
#undef FFGPU_FRAGMENT_COMPARE_LANES_INL_H_
#else
#define FFGPU_FRAGMENT_COMPARE_LANES_INL_H_
#endif

#include "model/device/registers/texture.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

template <class D, class V = hwy::HWY_NAMESPACE::Vec<D>>
HWY_INLINE auto compare_lanes(D /*lanes*/, Compare function, V value, V reference) {
    namespace hn = hwy::HWY_NAMESPACE;
    switch (function) {
    case Compare::Never:
        return hn::Lt(value, value);
    case Compare::Less:
        return hn::Lt(value, reference);
    case Compare::Equal:
        return hn::Eq(value, reference);
    case Compare::Lequal:
        return hn::Not(hn::Gt(value, reference));
    case Compare::Greater:
        return hn::Gt(value, reference);
    case Compare::Notequal:
        return hn::Ne(value, reference);
    case Compare::Gequal:
        return hn::Not(hn::Lt(value, reference));
    case Compare::Always:
        break;
    }
    return hn::Eq(value, value);
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
