#include "driver/trace/reader/trace_reader.h"
#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/trace/trace_writer.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <unistd.h>

namespace ffgpu::trace {
namespace {

using Catch::Matchers::Contains;

TraceReader open(const TemporaryFile& file) {
    return TraceReader(file.path());
}

// What was delivered before the end or the damage, and the damage.
struct Outcome {
    std::vector<std::string> names;
    std::string error;
    bool operator==(const Outcome&) const = default;
};

Outcome read_all(const std::string& file_bytes) {
    const TemporaryFile file(file_bytes);
    Outcome outcome;
    try {
        TraceReader reader(file.path());
        while (const Call* const call = reader.next())
            outcome.names.emplace_back(call->name());
    } catch (const InputError& error) {
        outcome.error = error.what();
    }
    return outcome;
}

// Three calls; the second with many kinds of values.
TraceWriter small_trace() {
    TraceWriter writer;
    writer.call(0, "glClear", {"mask"}, {[&] { writer.bitmask(0, 0x4100); }});
    writer.call(1,
                "glTexImage2D",
                {"target", "width", "pixels"},
                {[&] { writer.enumeration(0, 0x0de1); },
                 [&] { writer.sint(4); },
                 [&] { writer.blob(std::string(3000, 'x')); }});
    writer.call(0, "glClear", {"mask"}, {[&] { writer.bitmask(0, 0x100); }});
    return writer;
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

TEST_CASE("A trace cut at any byte delivers every call that is whole, then one clear line") {
    const TraceWriter writer = small_trace();
    const std::vector<std::string> all{"glClear", "glTexImage2D", "glClear"};
    std::size_t most = 0;
    for (std::size_t size = 1; size < writer.bytes.size(); ++size) {
        const Outcome outcome = read_all(in_snappy(writer.bytes.substr(0, size)));
        REQUIRE(outcome.names.size() <= all.size());
        CHECK(std::equal(outcome.names.begin(), outcome.names.end(), all.begin()));
        CHECK(outcome.names.size() >= most);
        most = outcome.names.size();
        CHECK(outcome.error.find('\n') == std::string::npos);
        // Only between two calls, or before the first, is the rest a whole trace.
        if (outcome.error.empty()) CHECK(outcome.names.size() < all.size());
    }
    CHECK(most == 2);
}

TEST_CASE("A file cut at any byte of its container delivers what can be decoded") {
    const TraceWriter writer = small_trace();
    for (const std::string& file :
         {in_snappy(writer.bytes, 500), in_gzip(writer.bytes), in_zstd(writer.bytes)}) {
        std::size_t most = 0;
        for (std::size_t size = 5; size < file.size(); ++size) {
            const Outcome outcome = read_all(file.substr(0, size));
            most = std::max(most, outcome.names.size());
            INFO(size << " of " << file.size());
            // Snappy's blocks have no end mark: a cut between two is seen in the calls only.
            if (outcome.error.empty()) CHECK(outcome.names.size() < 3);
        }
        // Zstandard holds such a small file in one block, which decodes as a whole or not.
        if (file != in_zstd(writer.bytes)) CHECK(most >= 1);
    }
}

TEST_CASE("Of a block that is cut off the place is told where what can be decoded ends") {
    const TraceWriter writer = small_trace();
    constexpr std::size_t First = 60, Magic = 2;
    const std::string file = in_snappy(writer.bytes.substr(0, First)) +
                             in_snappy(writer.bytes.substr(First)).substr(Magic);
    CHECK(read_all(file).error.empty());
    for (std::size_t cut = 1; cut < 40; ++cut) {
        const std::string error = read_all(file.substr(0, file.size() - cut)).error;
        INFO(error);
        REQUIRE_THAT(error, Contains("(uncompressed)") && Contains("is cut off"));
        const std::size_t at = std::stoull(error.substr(error.find(": byte ") + 7));
        CHECK(at >= First);
        CHECK(at < writer.bytes.size());
    }
}

TEST_CASE("Any flipped byte is survived") {
    const TraceWriter writer = small_trace();
    for (std::size_t at = 0; at < std::min<std::size_t>(writer.bytes.size(), 200); ++at) {
        for (const int flip : {1, 0x80, 0xff}) {
            std::string bytes = writer.bytes;
            bytes[at] = static_cast<char>(bytes[at] ^ flip);
            CHECK(read_all(in_snappy(bytes)).error.find('\n') == std::string::npos);
        }
    }
    const std::string file = in_snappy(writer.bytes);
    for (std::size_t at = 0; at < file.size(); ++at) {
        std::string bytes = file;
        bytes[at] = static_cast<char>(bytes[at] ^ 0xff);
        CHECK(read_all(bytes).error.find('\n') == std::string::npos);
    }
}

TEST_CASE("A wild length is refused, or ends with the file, without its memory") {
    const auto value_with_length = [](std::uint8_t tag, std::uint64_t length) {
        TraceWriter writer;
        writer.enter(0, "f", {"a"});
        writer.argument(0);
        writer.byte(tag);
        writer.uint(length);
        return read_all(in_snappy(writer.bytes)).error;
    };
    constexpr std::uint8_t String = 7, Bytes = 8, Array = 11, Wide = 15;
    constexpr std::uint64_t Wild = ~std::uint64_t{0};
    CHECK_THAT(value_with_length(String, Wild), Contains("text's length"));
    CHECK_THAT(value_with_length(Bytes, Wild), Contains("blob's length"));
    CHECK_THAT(value_with_length(Bytes, std::uint64_t{1} << 30), Contains("ends"));
    CHECK_THAT(value_with_length(Array, Wild), Contains("array's length"));
    CHECK_THAT(value_with_length(Array, 1 << 24), Contains("ends"));
    CHECK_THAT(value_with_length(Wide, Wild), Contains("ends"));

    std::string block_claims_much = "at" + std::string("\xff\xff\xff\x7f", 4) + "abc";
    CHECK_THAT(read_all(block_claims_much).error, Contains("cut off"));
    // The length of the uncompressed block: 4 GiB.
    std::string bomb =
        "at" + std::string("\x06\0\0\0", 4) + std::string("\xff\xff\xff\xff\x0f\0", 6);
    CHECK_THAT(read_all(bomb).error, Contains("damaged"));
}

TEST_CASE("Values nested without end are refused") {
    TraceWriter writer;
    writer.enter(0, "f", {"a"});
    writer.argument(0);
    for (int i = 0; i < 100000; ++i)
        writer.array(1);
    CHECK_THAT(read_all(in_snappy(writer.bytes)).error, Contains("nesting"));
}

TEST_CASE("What is no trace is named in one line") {
    CHECK_THAT(read_all("").error, Contains("is empty"));
    CHECK_THAT(read_all("Hello, this is text.\n").error, Contains("not a trace"));
    CHECK_THROWS_WITH(TraceReader("/nonexistent/x.trace"), Contains("cannot be opened"));
    CHECK_THROWS_WITH(TraceReader("/"), Contains("directory"));
    const std::string snappy = in_snappy(small_trace().bytes, 64);
    CHECK_THAT(read_all(in_gzip(snappy)).error, Contains("compressed once more"));
    CHECK_THAT(read_all(in_zstd(snappy)).error, Contains("compressed once more"));
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    CHECK_THROWS_WITH(TraceReader("/dev/fd/" + std::to_string(ends[0])), Contains("is a pipe"));
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_CASE("A damaged place is named by byte and call") {
    TraceWriter writer = small_trace();
    writer.enter(0, "glClear", {"mask"});
    writer.argument(0);
    writer.byte(0x42);
    const Outcome outcome = read_all(in_snappy(writer.bytes));
    CHECK(outcome.names.size() == 3);
    CHECK_THAT(outcome.error,
               Contains("byte " + std::to_string(writer.bytes.size())) &&
                   Contains("call 3 glClear") && Contains("found 66"));
}

TEST_CASE("What is no name is refused before anybody is shown it") {
    const std::string name = GENERATE("gl\x1b[2JClear", "glClea\xff", "glClear\n");
    const bool of_argument = GENERATE(false, true);
    TraceWriter writer = small_trace();
    writer.enter(99, of_argument ? "glClear" : name, {of_argument ? name : "mask"});
    const Outcome outcome = read_all(in_snappy(writer.bytes));
    CHECK(outcome.names.size() == 3);
    CHECK_THAT(outcome.error, Contains("expected a name's letters") && !Contains(name));
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
