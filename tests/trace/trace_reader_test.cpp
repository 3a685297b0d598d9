#include "tests/trace/small_trace.h"

#include <limits>

#include <catch2/catch.hpp>

namespace ffgpu::trace {
namespace {

using Catch::Matchers::Contains;

TraceReader open(const TemporaryFile& file) {
    return TraceReader(file.path());
}

TEST_CASE("Every kind of value is read as it was written") {
    TraceWriter writer;
    const std::vector<std::function<void()>> values{
        [&] { writer.null(); },
        [&] { writer.boolean(false); },
        [&] { writer.boolean(true); },
        [&] { writer.sint(-5); },
        [&] { writer.sint(std::numeric_limits<std::int64_t>::min()); },
        [&] { writer.sint(1234567890123); },
        [&] { writer.float32(0.1f); },
        [&] { writer.float64(-1e300); },
        [&] { writer.string("text"); },
        [&] { writer.blob(std::string("a\0b", 3)); },
        [&] { writer.enumeration(3, -7); },
        [&] { writer.bitmask(2, 0x80000001); },
        [&] { writer.pointer(0x7fff12345678); },
        [&] {
            writer.wide_string({0x263a, 65});
        },
    };
    writer.call(5, "f", std::vector<std::string>(values.size(), "a"), values);
    const TemporaryFile file(in_snappy(writer.bytes));
    TraceReader reader = open(file);
    const Call* const call = reader.next();
    REQUIRE(call);
    CHECK(call->argument(0).is_null());
    CHECK(to_number<int>(call->argument(1)) == 0);
    CHECK(to_number<int>(call->argument(2)) == 1);
    CHECK(to_number<int>(call->argument(3)) == -5);
    CHECK(to_number<std::int64_t>(call->argument(4)) == std::numeric_limits<std::int64_t>::min());
    CHECK(to_number<std::int64_t>(call->argument(5)) == 1234567890123);
    CHECK(to_number<float>(call->argument(6)) == 0.1f);
    CHECK(to_number<double>(call->argument(7)) == -1e300);
    CHECK(call->text(call->argument(8)) == "text");
    const Blob& blob = call->blob(call->argument(9));
    CHECK(std::string(reinterpret_cast<const char*>(blob.data()), blob.size()) ==
          std::string("a\0b", 3));
    CHECK(to_number<int>(call->argument(10)) == -7);
    CHECK(to_number<std::uint32_t>(call->argument(11)) == 0x80000001);
    CHECK(to_number<std::uint64_t>(call->argument(12)) == 0x7fff12345678);
    CHECK(call->argument(13).kind == ValueKind::WideString);
    CHECK(reader.next() == nullptr);
}

TEST_CASE("Arrays, structs and representations nest, and what follows them is found") {
    TraceWriter writer;
    writer.call(0,
                "f",
                {"nested", "after"},
                {[&] {
                     writer.array(3);
                     writer.structure(0, {"x", "y"});
                     writer.sint(1);
                     writer.array(2);
                     writer.sint(2);
                     writer.sint(3);
                     writer.repr();
                     writer.string("four");
                     writer.sint(4);
                     writer.sint(5);
                 },
                 [&] { writer.sint(6); }});
    const TemporaryFile file(in_snappy(writer.bytes));
    TraceReader reader = open(file);
    const Call* const call = reader.next();
    REQUIRE(call);
    std::vector<ValueKind> kinds;
    Call::for_each(call->argument(0), [&](const Value& value) { kinds.push_back(value.kind); });
    CHECK(kinds == std::vector{ValueKind::Struct, ValueKind::Repr, ValueKind::Unsigned});
    CHECK(call->argument(0).extent == 10);
    CHECK(to_number<int>(call->argument("after")) == 6);
    CHECK(call->argument("missing").is_null());
}

TEST_CASE("Arguments are found in whatever order a trace has them") {
    const auto read = [](const std::vector<std::pair<unsigned, int>>& arguments) {
        TraceWriter writer;
        writer.enter(0, "f", {"a", "b", "c"});
        for (const auto& [index, value] : arguments) {
            writer.argument(index);
            writer.sint(value);
        }
        writer.end();
        writer.leave(0);
        writer.result();
        writer.sint(9);
        writer.end();
        const TemporaryFile file(in_snappy(writer.bytes));
        TraceReader reader = open(file);
        const Call* const call = reader.next();
        REQUIRE(call);
        CHECK(to_number<int>(call->result()) == 9);
        std::vector<int> found;
        for (std::size_t i = 0; i < 3; ++i)
            found.push_back(call->argument(i).is_null() ? -1 : to_number<int>(call->argument(i)));
        return found;
    };
    CHECK(read({{0, 1}, {1, 2}, {2, 3}}) == std::vector{1, 2, 3});
    CHECK(read({{2, 3}, {0, 1}, {1, 2}}) == std::vector{1, 2, 3});
    CHECK(read({{0, 1}, {2, 3}}) == std::vector{1, -1, 3});
    CHECK(read({{1, 2}}) == std::vector{-1, 2, -1});
    // The last one of an argument that comes twice.
    CHECK(read({{0, 1}, {1, 2}, {0, 4}, {2, 3}}) == std::vector{4, 2, 3});
}

TEST_CASE("A real number becomes an integer without leaving its range") {
    const auto real = [](double value) {
        return Value{ValueKind::Real, 1, std::bit_cast<std::uint64_t>(value)};
    };
    CHECK(to_number<std::int32_t>(real(1e30)) == std::numeric_limits<std::int32_t>::max());
    CHECK(to_number<std::int32_t>(real(-1e30)) == std::numeric_limits<std::int32_t>::min());
    CHECK(to_number<std::uint8_t>(real(-1)) == 0);
    CHECK(to_number<std::uint64_t>(real(1e30)) == std::numeric_limits<std::uint64_t>::max());
    CHECK(to_number<std::int32_t>(real(std::nan(""))) == 0);
    CHECK(to_number<std::int32_t>(real(-2.9)) == -2);
}

TEST_CASE("A result and an argument of the leave event belong to their call") {
    TraceWriter writer;
    writer.enter(0, "glGenTextures", {"n", "textures"});
    writer.argument(0);
    writer.sint(2);
    writer.end();
    writer.leave(0);
    writer.argument(1);
    writer.array(2);
    writer.sint(8);
    writer.sint(9);
    writer.result();
    writer.sint(77);
    writer.end();
    const TemporaryFile file(in_snappy(writer.bytes));
    TraceReader reader = open(file);
    const Call* const call = reader.next();
    REQUIRE(call);
    std::vector<int> names;
    Call::for_each(call->argument(1),
                   [&](const Value& value) { names.push_back(to_number<int>(value)); });
    CHECK(names == std::vector{8, 9});
    CHECK(to_number<int>(call->result()) == 77);
}

TEST_CASE("Calls of two threads interleave and come in the order of their ends") {
    TraceWriter writer;
    writer.enter(0, "first", {}, 1);
    writer.end();
    writer.enter(1, "second", {}, 2);
    writer.end();
    writer.leave(1);
    writer.end();
    writer.enter(1, "second", {}, 2);
    writer.flags(1);
    writer.end();
    writer.leave(0);
    writer.end();
    writer.leave(2);
    writer.end();
    const TemporaryFile file(in_snappy(writer.bytes));
    TraceReader reader = open(file);
    std::vector<std::tuple<std::string, std::uint64_t, std::uint32_t, bool>> calls;
    while (const Call* const call = reader.next())
        calls.emplace_back(call->name(), call->number(), call->thread(), call->is_fake());
    CHECK(calls ==
          decltype(calls){{"second", 1, 2, false}, {"first", 0, 1, false}, {"second", 2, 2, true}});
}

TEST_CASE("All versions up to 6 are read, a newer one is refused by its number") {
    for (std::uint64_t version = 1; version <= 6; ++version) {
        TraceWriter writer(version);
        writer.enter(0, "glEnable", {"cap"});
        if (version < 4) writer.thread(5);
        writer.argument(0);
        writer.enumeration(0, 0x0b71);
        writer.end();
        writer.leave(0);
        writer.end();
        const TemporaryFile file(in_snappy(writer.bytes));
        TraceReader reader = open(file);
        CHECK(reader.version() == version);
        const Call* const call = reader.next();
        REQUIRE(call);
        CHECK(to_number<int>(call->argument(0)) == 0x0b71);
        CHECK(call->thread() == (version < 4 ? 5 : 0));
        CHECK(reader.next() == nullptr);
    }
    CHECK_THAT(read_all(in_snappy(TraceWriter(7).bytes)).error,
               Contains("version 7") && Contains("up to 6"));
}

TEST_CASE("All containers and chunk sizes deliver the same calls") {
    const TraceWriter writer = small_trace();
    const Outcome expected{{"glClear", "glTexImage2D", "glClear"}, ""};
    CHECK(read_all(in_gzip(writer.bytes)) == expected);
    CHECK(read_all(in_zstd(writer.bytes)) == expected);
    for (std::size_t chunk = 1; chunk < 100; ++chunk)
        CHECK(read_all(in_snappy(writer.bytes, chunk)) == expected);
    // Two gzip members, two Zstandard frames.
    const std::string head = writer.bytes.substr(0, 99), tail = writer.bytes.substr(99);
    CHECK(read_all(in_gzip(head) + in_gzip(tail)) == expected);
    CHECK(read_all(in_zstd(head) + in_zstd(tail)) == expected);
}

TEST_CASE("A trace is read again from its beginning") {
    const TraceWriter writer = small_trace();
    for (const std::string& bytes :
         {in_snappy(writer.bytes), in_gzip(writer.bytes), in_zstd(writer.bytes)}) {
        const TemporaryFile file(bytes);
        TraceReader reader = open(file);
        reader.next();
        reader.rewind();
        unsigned calls = 0;
        while (const Call* const call = reader.next())
            CHECK(call->number() == calls++);
        CHECK(calls == 3);
    }
}

} // namespace
} // namespace ffgpu::trace
