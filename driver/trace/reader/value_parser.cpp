#include "driver/trace/reader/value_parser.h"

namespace ffgpu::trace {
namespace {

// How a file tags its values.
enum Tag : std::uint8_t {
    NullTag,
    FalseTag,
    TrueTag,
    NegativeTag, // An unsigned integer follows: sign and magnitude.
    UnsignedTag,
    FloatTag,
    DoubleTag,
    StringTag,
    BlobTag,
    EnumTag,
    BitmaskTag,
    ArrayTag,
    StructTag,
    PointerTag,
    ReprTag,
    WideStringTag,
};

// Far beyond what a program hands to OpenGL, near enough that a bomb does not eat the machine.
constexpr unsigned MaxDepth = 32;
constexpr std::size_t MaxValues = std::size_t{1} << 24;
constexpr std::uint64_t MaxTextBytes = std::uint64_t{1} << 28;
constexpr std::uint64_t MaxBlobBytes = std::uint64_t{1} << 30;
constexpr std::uint64_t MaxNameBytes = 4096;

void limit(std::uint64_t length, std::uint64_t most, const char* of) {
    if (length > most)
        throw Damage{std::string("expected ") + of + " of at most " + std::to_string(most) +
                     ", found " + std::to_string(length)};
}

struct TextBuffer {
    std::string& text;
    void append(const std::byte* bytes, std::size_t count) {
        text.append(reinterpret_cast<const char*>(bytes), count);
    }
};

Value number(ValueKind kind, std::uint64_t bits) {
    return {kind, 1, bits};
}

} // namespace

void ValueParser::parse(Call& call, unsigned depth) {
    limit(depth, MaxDepth, "a nesting");
    limit(call.values_.size(), MaxValues, "a number of values in a call");
    const std::uint8_t tag = stream_.byte();
    const std::size_t at = call.values_.size();
    Value& value = call.values_.emplace_back();
    switch (tag) {
    case NullTag:
        return;
    case EnumTag:
        value = parse_enum();
        return;
    case BitmaskTag:
        value = parse_bitmask();
        return;
    case StringTag:
        value = parse_text(call);
        return;
    case BlobTag:
        value = parse_blob(call);
        return;
    case WideStringTag:
        value.kind = ValueKind::WideString;
        skip_wide_string();
        return;
    case ArrayTag:
        value.kind = ValueKind::Array;
        return parse_children(call, at, stream_.uint(), depth);
    case StructTag:
        value.kind = ValueKind::Struct;
        return parse_children(call, at, parse_struct_signature().members, depth);
    case ReprTag:
        value.kind = ValueKind::Repr;
        return parse_children(call, at, 2, depth);
    default:
        value = parse_number(tag);
    }
}

void ValueParser::parse_children(Call& call,
                                 std::size_t parent,
                                 std::uint64_t count,
                                 unsigned depth) {
    limit(count, MaxValues, "an array's length");
    for (std::uint64_t i = 0; i < count; ++i)
        parse(call, depth + 1);
    call.values_[parent].bits = count;
    call.values_[parent].extent = static_cast<std::uint32_t>(call.values_.size() - parent);
}

Value ValueParser::parse_number(std::uint8_t tag) {
    switch (tag) {
    case FalseTag:
        return number(ValueKind::Bool, 0);
    case TrueTag:
        return number(ValueKind::Bool, 1);
    case NegativeTag:
        return number(ValueKind::Signed, 0 - stream_.uint());
    case UnsignedTag:
        return number(ValueKind::Unsigned, stream_.uint());
    case FloatTag:
        return number(ValueKind::Real, std::bit_cast<std::uint64_t>(double{stream_.float32()}));
    case DoubleTag:
        return number(ValueKind::Real, std::bit_cast<std::uint64_t>(stream_.float64()));
    case PointerTag:
        return number(ValueKind::Pointer, stream_.uint());
    default:
        throw Damage{"expected a value's kind (0 to 15), found " + std::to_string(tag)};
    }
}

// The definition lists all names of the enum; the value itself is a tagged integer.
Value ValueParser::parse_enum() {
    const std::uint64_t id = stream_.uint();
    const EnumDefinition* definition = enums_.find(id);
    if (!definition) {
        auto fresh = std::make_unique<EnumDefinition>();
        if (version_ < 3) {
            skip_name();
            fresh->old_value = parse_number(stream_.byte());
        } else {
            for (std::uint64_t left = stream_.uint(); left > 0; --left) {
                skip_name();
                parse_number(stream_.byte());
            }
        }
        definition = &enums_.define(id, std::move(fresh));
    }
    const Value value = version_ < 3 ? definition->old_value : parse_number(stream_.byte());
    return number(ValueKind::Enum, to_number<std::uint64_t>(value));
}

// Unlike an enum's, a bit mask's numbers carry no tags.
Value ValueParser::parse_bitmask() {
    const std::uint64_t id = stream_.uint();
    if (!bitmasks_.find(id)) {
        for (std::uint64_t left = stream_.uint(); left > 0; --left) {
            skip_name();
            stream_.uint();
        }
        bitmasks_.define(id, std::make_unique<BitmaskDefinition>());
    }
    return number(ValueKind::Bitmask, stream_.uint());
}

Value ValueParser::parse_text(Call& call) {
    const std::uint64_t length = stream_.uint();
    const std::uint64_t at = call.text_.size();
    limit(at + length, MaxTextBytes, "a text's length");
    TextBuffer buffer{call.text_};
    stream_.append(buffer, length);
    return number(ValueKind::String, at << 32 | length);
}

Value ValueParser::parse_blob(Call& call) {
    const std::uint64_t length = stream_.uint();
    limit(length, MaxBlobBytes, "a blob's length");
    if (call.blob_count_ == call.blobs_.size()) call.blobs_.push_back(std::make_unique<Blob>());
    Blob& blob = *call.blobs_[call.blob_count_];
    blob.clear();
    stream_.append(blob, length);
    return number(ValueKind::Blob, call.blob_count_++);
}

void ValueParser::skip_wide_string() {
    for (std::uint64_t left = stream_.uint(); left > 0; --left)
        stream_.uint();
}

const ValueParser::StructDefinition& ValueParser::parse_struct_signature() {
    const std::uint64_t id = stream_.uint();
    if (const StructDefinition* known = structs_.find(id)) return *known;
    skip_name();
    const std::uint64_t members = stream_.uint();
    limit(members, MaxNameBytes, "a struct's number of members");
    for (std::uint64_t i = 0; i < members; ++i)
        skip_name();
    auto fresh = std::make_unique<StructDefinition>();
    fresh->members = static_cast<std::uint32_t>(members);
    return structs_.define(id, std::move(fresh));
}

std::string ValueParser::parse_name() {
    const std::uint64_t length = stream_.uint();
    limit(length, MaxNameBytes, "a name's length");
    std::string name;
    TextBuffer buffer{name};
    stream_.append(buffer, length);
    return name;
}

void ValueParser::skip_name() {
    parse_name();
}

} // namespace ffgpu::trace
