// Exports of whole traces: every line against the grammar of the program that reads it, the
// look-ups through a cache that shares no code with the curves, and the bytes against the figures
// of the machine in time.

#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tests/tools/tool.h"
#include "tests/work/din_player.h"
#include "tools/cache/cache_study.h"
#include "tools/export/export.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <regex>
#include <sstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <sys/wait.h>
#include <zstd.h>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
using work::LookupClient;

constexpr FrameRange Frames{0, 1};

std::vector<std::string> exported(ExportOptions options) {
    const TemporaryFile file("", ".export");
    options.output = file.path();
    options.frames = Frames;
    export_trace(options);
    std::istringstream text(content(file.path()));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

void check_grammar(const std::vector<std::string>& lines, const char* grammar) {
    const std::regex line_of(grammar);
    for (const std::string& line : lines) {
        if (std::regex_match(line, line_of)) continue;
        FAIL_CHECK(line);
        return;
    }
}

TEST_CASE("din in another program's cache has the misses and write-backs of the curves",
          "[export]") {
    std::mt19937 random(50);
    for (const std::string& name : own_traces()) {
        CacheStudyOptions study{.input = own_trace(name),
                                .frames = Frames,
                                .clients = {LookupClient::Texel,
                                            LookupClient::Depth,
                                            LookupClient::Color,
                                            LookupClient::Vertex},
                                .line_bytes = {64}};
        CacheStudyResult result;
        study_caches(study, result);
        for (const CurveResult& curve : result.curves) {
            ExportOptions options{.input = study.input, .client = curve.client};
            const bool texel = curve.client == LookupClient::Texel;
            options.format = texel ? ExportFormat::Din : ExportFormat::Xdin;
            const std::vector<std::string> lines = exported(options);
            check_grammar(lines, texel ? "[014] [0-9a-f]+" : "[rwcv] [0-9a-f]+ [0-9a-f]+");
            const auto shapes = told_geometries(study, curve);
            for (unsigned i = 0; i < 13; ++i) { // more than 50 of each trace
                const CacheGeometry& shape = shapes[random() % shapes.size()];
                INFO(name << ": client " << static_cast<int>(curve.client) << ", " << shape.sets
                          << "x" << shape.ways);
                test::PlainCache cache(shape.sets, shape.ways);
                texel ? test::play_din(lines, cache) : test::play_xdin(lines, cache);
                const work::CacheCounts counts = curve.sums.counts(shape.sets, shape.ways);
                CHECK(cache.counts.accesses == counts.accesses);
                CHECK(cache.counts.misses == counts.misses);
                CHECK(cache.counts.write_backs == counts.write_backs);
            }
        }
    }
}

TEST_CASE("a machine that tests depth late looks up the texels of hidden fragments", "[export]") {
    const std::string trace = own_trace("tour");
    timing::TimingConfig timing;
    timing.depth.test = work::DepthTest::Late;
    const Run run = run_trace(trace, {.timing = timing, .last_frame = Frames.last});
    ExportOptions options{.input = trace, .format = ExportFormat::Xdin};
    options.configuration.timing = timing;
    test::PlainCache cache(64, 4);
    test::play_xdin(exported(options), cache);
    CHECK(cache.counts.accesses == run.timed.at("texel_cache_accesses"));
    CHECK(cache.counts.misses == run.timed.at("texel_cache_misses"));
}

TEST_CASE("csv holds the bytes of each client that the machine in time counts", "[export]") {
    timing::TimingConfig timing;
    timing.scan_out.refresh_cycles = 200000;
    for (const std::string& name : own_traces()) {
        INFO(name);
        const Run run = run_trace(own_trace(name), {.timing = timing, .last_frame = Frames.last});
        ExportOptions options{.input = own_trace(name), .format = ExportFormat::Csv};
        options.configuration.timing = timing;
        const std::vector<std::string> lines = exported(options);
        REQUIRE(lines.front() ==
                "cycle,unit,operation,address,bytes,draw,primitive,texture,level,tile,x,y");
        check_grammar({lines.begin() + 1, lines.end()},
                      "[0-9]+,[a-z_]+,(read|write),0x[0-9a-f]+,[0-9]+,([0-9]*,){2}"
                      "((0x[0-9a-f]+)?,[0-9]*),([0-9]+:[0-9]+)?(,[0-9]*){2}");
        std::map<std::string, std::uint64_t> bytes;
        std::uint64_t last = 0, textured = 0, without_quad = 0;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            std::istringstream line(lines[i]);
            std::vector<std::string> cells;
            for (std::string cell; std::getline(line, cell, ',');)
                cells.push_back(cell);
            bytes[cells[1] + (cells[2] == "read" ? "_read" : "_written")] += std::stoull(cells[4]);
            CHECK(std::stoull(cells[0]) >= last);
            last = std::stoull(cells[0]);
            textured += cells[1] == "texture";
            without_quad += cells[1] == "texture" && (cells.size() < 12 || cells[7].empty());
        }
        for (const char* const client : {"command",
                                         "vertex",
                                         "texture",
                                         "depth",
                                         "color",
                                         "index",
                                         "host",
                                         "scan_out",
                                         "parameter"})
            for (const char* const what : {"_read", "_written"}) {
                INFO(client << what);
                CHECK(bytes[std::string(client) + what] ==
                      run.timed.at("memory_" + std::string(client) + what + "_bytes"));
            }
        CHECK(textured > 0);
        CHECK(bytes["scan_out_read"] > 0);
        CHECK(without_quad == 0);
    }
}

struct Accesses {
    std::uint64_t reads = 0, writes = 0, read_bytes = 0, written_bytes = 0;
};

// What the requests of the csv take in records of 64 bytes.
Accesses accesses_of(const std::vector<std::string>& csv) {
    Accesses all;
    for (std::size_t i = 1; i < csv.size(); ++i) {
        char unit[32], operation[8];
        unsigned long long cycle = 0, address = 0, bytes = 0;
        REQUIRE(std::sscanf(csv[i].c_str(),
                            "%llu,%31[^,],%7[^,],0x%llx,%llu",
                            &cycle,
                            unit,
                            operation,
                            &address,
                            &bytes) == 5);
        const std::uint64_t records = (address + bytes - 1) / 64 - address / 64 + 1;
        const bool read = operation[0] == 'r';
        (read ? all.reads : all.writes) += records;
        (read ? all.read_bytes : all.written_bytes) += bytes;
    }
    return all;
}

TEST_CASE("the formats of memory simulators hold the machine's requests", "[export]") {
    ExportOptions options{.input = own_trace("corridor"), .format = ExportFormat::Csv};
    const Accesses all = accesses_of(exported(options));
    const auto count = [](const std::vector<std::string>& lines, const std::string& word) {
        return static_cast<std::uint64_t>(
            std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
                return line.find(word) != std::string::npos;
            }));
    };
    const auto of = [&](ExportFormat format, const char* grammar) {
        options.format = format;
        std::vector<std::string> lines = exported(options);
        check_grammar(lines, grammar);
        return lines;
    };
    const auto ramulator = of(ExportFormat::Ramulator2, "(LD|ST) 0x[0-9a-f]+");
    CHECK(count(ramulator, "LD") == all.reads);
    CHECK(count(ramulator, "ST") == all.writes);
    const auto vectors =
        of(ExportFormat::Ramulator2Vectors, "[RW] [01],0,0,[0-3],[0-9]+,([0-9]|[12][0-9]|3[01])");
    CHECK(count(vectors, "R ") == all.reads);
    CHECK(count(vectors, "W ") == all.writes);
    const auto dramsim = of(ExportFormat::Dramsim3, "0x[0-9A-F]+ (READ|WRITE) [0-9]+");
    CHECK(count(dramsim, "READ") == all.reads);
    CHECK(count(dramsim, "WRITE") == all.writes);
    const auto dramsys =
        of(ExportFormat::Dramsys, "[0-9]+:\t\\([0-9]+\\) (read|write)\t0x[0-9a-f]+");
    Accesses told;
    for (const std::string& line : dramsys) {
        const std::uint64_t bytes = std::stoull(line.substr(line.find('(') + 1));
        (line.find("read") != std::string::npos ? told.read_bytes : told.written_bytes) += bytes;
    }
    CHECK(told.read_bytes == all.read_bytes);
    CHECK(told.written_bytes == all.written_bytes);
}

TEST_CASE("a compressed export is the plain one", "[export]") {
    const TemporaryFile plain("", ".din"), packed("", ".zst");
    const std::string trace = own_trace("chrome");
    export_trace({.input = trace, .output = plain.path(), .frames = {0, 0}});
    export_trace({.input = trace, .output = packed.path(), .frames = {0, 0}, .compresses = true});
    const std::string expected = content(plain.path()), bytes = content(packed.path());
    CHECK(bytes.size() < expected.size() / 2);
    std::string text(expected.size() + 1, '\0');
    ZSTD_DCtx* const context = ZSTD_createDCtx();
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    ZSTD_outBuffer out{text.data(), text.size(), 0};
    CHECK(ZSTD_decompressStream(context, &out, &in) == 0);
    ZSTD_freeDCtx(context);
    text.resize(out.pos);
    CHECK(text == expected);
}

TEST_CASE("what is wrong with an export is one line, and status 2", "[export]") {
    const std::string trace = own_trace("corridor");
    const auto fails = [](const std::vector<std::string>& arguments) {
        int status = 0;
        std::string text = printed(stderr, [&] { status = run(arguments); });
        CHECK(status == 2);
        CHECK(std::count(text.begin(), text.end(), '\n') == 1);
        return text;
    };
    CHECK_THAT(fails({"export", trace, "--format", "dinn"}), Contains("did you mean 'din'?"));
    CHECK_THAT(fails({"export", trace, "--format", "din", "--client", "texl"}),
               Contains("did you mean 'texel'?"));
    CHECK_THAT(fails({"export", trace, "--format", "din", "-o", "/dev/full"}),
               Contains("/dev/full: cannot be written: No space left on device"));
    for (const char* const format : {"dramsim3", "ramulator2", "dram_commands", "perfetto", "vcd"})
        CHECK_THAT(fails({"export", trace, "--format", format, "-o", "/dev/full"}),
                   Contains("No space left on device"));
    CHECK_THAT(fails({"export", trace, "--format", "csv", "--access-bytes", "48"}),
               Contains("--access-bytes 48"));
    // The machine's channels change behind 256 bytes.
    CHECK_THAT(fails({"export", trace, "--format", "ramulator2_vectors", "--access-bytes", "512"}),
               Contains("no more than 256 bytes"));
    const TemporaryFile newer(std::string("FFGPUWRK\x09\0\0\0", 12), ".ffw");
    CHECK_THAT(fails({"export", newer.path(), "--format", "din"}), Contains(newer.path()));
}

TEST_CASE("a reader that stops ends what prints without a word, by SIGPIPE", "[export]") {
    const std::string trace = own_trace("corridor");
    for (const std::string& verb : {"export '" + trace + "' --format din",
                                    "export '" + trace + "' --format csv --zstd",
                                    "info '" + trace + "'",
                                    std::string("config"),
                                    std::string("presets"),
                                    std::string("completion bash"),
                                    std::string("export --help")}) {
        for (const char* const before : {"", "trap '' PIPE; "}) {
            INFO(before << verb);
            const TemporaryFolder folder;
            const std::string said = folder / "said", ended = folder / "ended";
            // The reader is gone before the first byte.
            const std::string command =
                fmt::format("{}(sleep 0.1; '" FFGPU_BINARY "' {} 2> {}; echo $? > {}) | exec true",
                            before,
                            verb,
                            said,
                            ended);
            REQUIRE(std::system(command.c_str()) == 0);
            CHECK(content(said).empty());
            CHECK(content(ended) == "141\n"); // 128 + SIGPIPE
        }
    }
}

TEST_CASE("a disk that is full in the middle of an export leaves the former file", "[export]") {
    const TemporaryFolder folder;
    const std::string file = folder / "corridor.din", said = folder / "said";
    std::ofstream(file) << "former\n";
    const std::string command = "ulimit -f 64; exec '" FFGPU_BINARY "' export '" +
                                own_trace("corridor") + "' --format din -o " + file + " 2> " + said;
    const int status = std::system(command.c_str());
    CHECK(WEXITSTATUS(status) == 2);
    const std::string text = content(said);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    CHECK_THAT(text, Contains(file + ": cannot be written"));
    CHECK(content(file) == "former\n");
    const std::filesystem::directory_iterator files(folder.path());
    CHECK(std::distance(begin(files), end(files)) == 2);
}

TEST_CASE("a fault of the input keeps what was exported before it", "[export]") {
    const TemporaryFile work("", ".ffw"), whole("", ".din"), part("", ".din");
    const std::string trace = own_trace("chrome");
    REQUIRE(run({"replay", trace, "--no-images", "--frames", "0-3", "--save-work", work.path()}) ==
            0);
    export_trace({.input = work.path(), .output = whole.path()});
    const std::string bytes = content(work.path());
    std::ofstream(work.path(), std::ios::binary) << bytes.substr(0, bytes.size() * 9 / 10);
    CHECK_THROWS_AS(export_trace({.input = work.path(), .output = part.path()}), InputError);
    const std::string kept = content(part.path()), all = content(whole.path());
    CHECK(kept.size() > 1000);
    CHECK(kept.size() < all.size());
    CHECK(all.compare(0, kept.size(), kept) == 0);
}

} // namespace
} // namespace ffgpu::tools
