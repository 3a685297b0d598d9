// Which values the fields of the contract may hold. A command stream may come from a file.

#pragma once

#include "model/device/commands.h"

#include <type_traits>

namespace ffgpu {

// The last enumerator of the types that do not fill the bits of their fields; of the others any
// bits are a value.
template <class Enum>
constexpr Enum LastEnumerator = static_cast<Enum>(255);
template <>
inline constexpr Format
    LastEnumerator<Format> = static_cast<Format>(static_cast<unsigned>(Format::Count) - 1);
template <>
inline constexpr auto LastEnumerator<PrimitiveType> = PrimitiveType::Polygon;
template <>
inline constexpr auto LastEnumerator<IndexType> = IndexType::U32;
template <>
inline constexpr auto LastEnumerator<NormalMode> = NormalMode::Normalize;
template <>
inline constexpr auto LastEnumerator<TexGenMode> = TexGenMode::ReflectionMap;
template <>
inline constexpr auto LastEnumerator<PolygonMode> = PolygonMode::Fill;
template <>
inline constexpr auto LastEnumerator<TextureKind> = TextureKind::Rectangle;
template <>
inline constexpr auto LastEnumerator<MipFilter> = MipFilter::Linear;
template <>
inline constexpr auto LastEnumerator<DepthMode> = DepthMode::Alpha;
template <>
inline constexpr auto LastEnumerator<CombineOp> = CombineOp::AddProductsSigned;
template <>
inline constexpr auto LastEnumerator<CombineSource> = CombineSource::One;
template <>
inline constexpr auto LastEnumerator<BlendFactor> = BlendFactor::SourceAlphaSaturate;
template <>
inline constexpr auto LastEnumerator<BlendEquation> = BlendEquation::Max;

// The name of the first field of a register or command that holds no value of its kind; null where
// every field does.
template <class Packed>
constexpr const char* find_bad_enumerator(const Packed& packed) {
    const char* bad = nullptr;
    Packed::visit(packed, [&bad](const char* name, const auto& field, unsigned = 32) {
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (std::is_enum_v<Field>)
            if (!bad && field > LastEnumerator<Field>) bad = name;
    });
    return bad;
}

} // namespace ffgpu
