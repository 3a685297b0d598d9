// Traces that are cut off, damaged, or none: what is whole is delivered, then one clear line.

#include "tests/trace/small_trace.h"

#include <algorithm>

#include <catch2/catch.hpp>

namespace ffgpu::trace {
namespace {

using Catch::Matchers::Contains;

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

} // namespace
} // namespace ffgpu::trace
