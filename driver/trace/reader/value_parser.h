// ValueParser: the grammar of values, and the definitions of enums, bit masks and structs that
// come inline with their first use.

#pragma once

#include "driver/trace/reader/byte_stream.h"
#include "driver/trace/reader/call.h"
#include "driver/trace/reader/id_table.h"

#include <cstdint>
#include <string>

namespace ffgpu::trace {

class ValueParser {
public:
    // `version`: of the file; before 3 an enum was defined by one name and value.
    ValueParser(ByteStream& stream, std::uint64_t version)
        : stream_(stream)
        , version_(version) {}

    // Reads a value and appends it to the call's.
    void parse(Call& call) { parse(call, 0); }

    // A string that is kept as a name.
    std::string parse_name();

private:
    struct EnumDefinition {
        Value old_value; // version < 3
    };
    struct BitmaskDefinition {};
    struct StructDefinition {
        std::uint32_t members = 0;
    };

    void parse(Call& call, unsigned depth);
    void parse_children(Call& call, std::size_t parent, std::uint64_t count, unsigned depth);
    Value parse_number(std::uint8_t kind);
    Value parse_enum();
    Value parse_bitmask();
    Value parse_text(Call& call);
    Value parse_blob(Call& call);
    void skip_wide_string();
    const StructDefinition& parse_struct_signature();
    void skip_name();

    ByteStream& stream_;
    std::uint64_t version_;
    IdTable<EnumDefinition> enums_;
    IdTable<BitmaskDefinition> bitmasks_;
    IdTable<StructDefinition> structs_;
};

} // namespace ffgpu::trace
