// `ffgpu check`: suites, verdicts, and what is written of them.

#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"
#include "tools/check/reports.h"
#include "tools/image/image.h"
#include "tools/replay/interruption.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

// A folder with a trace of four frames, red and green in turn, and a suite.
struct Workshop {
    TemporaryFolder folder;
    Workshop() {
        std::ofstream(folder / "clears.trace", std::ios::binary) << trace::in_snappy(clears(4));
    }
    void suite(const std::string& text) const { std::ofstream(folder / "suite.toml") << text; }
    int check(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"check", folder / "suite.toml", "-o", folder / "out"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    std::string junit() const { return content(folder / "out/junit.xml"); }
};

constexpr const char* One = "[[trace]]\ninput = 'clears.trace'\nreference = 'wanted'\n";

TEST_CASE("A suite passes against what it kept, and fails where a picture is another") {
    const Workshop shop;
    shop.suite(One);
    CHECK(shop.check() == 1); // no references
    CHECK_THAT(shop.junit(), Contains("tests=\"4\" failures=\"0\" errors=\"4\""));
    CHECK_THAT(shop.junit(), Contains("frame_0000.png: does not exist"));
    CHECK(shop.check({"--update"}) == 0);
    CHECK(shop.check() == 0);
    CHECK_THAT(shop.junit(),
               Contains("<testsuite name=\"clears\" tests=\"4\" failures=\"0\"") &&
                   !Contains("<failure"));

    const std::string changed = shop.folder / "wanted/frame_0002.png";
    Image image = read_image(changed);
    image.rgb[3 * 9 + 2] = 96; // One pixel's blue, 0 before: 96^2 / (3 x 32) has the root 9.798.
    write_png(changed, image);
    CHECK(shop.check() == 1);
    CHECK_THAT(shop.junit(), Contains("tests=\"4\" failures=\"1\" errors=\"0\""));
    CHECK_THAT(shop.junit(),
               Contains("<testcase classname=\"clears\" name=\"frame_0002\">\n      <failure "
                        "message=\"rmse 9.798 (at most 0), worst 96 at (1, 1)\">"
                        "rmse 9.798 (at most 0), worst 96 at (1, 1)</failure>"));
    const Image difference = read_image(shop.folder / "out/clears/frame_0002_difference.png");
    CHECK(difference.rgb[3 * 9 + 2] == 255);
    CHECK_THAT(content(shop.folder / "out/index.html"),
               Contains("3 passed, 1 failed, 0 errors") &&
                   Contains("<img src=\"clears/frame_0002_reference.png\""));
}

TEST_CASE("A tolerance is the suite's or a trace's own, for the mean and for the worst pixel") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    const std::string changed = shop.folder / "wanted/frame_0000.png";
    Image image = read_image(changed);
    image.rgb[2] = 96;
    write_png(changed, image);
    const auto status = [&](const std::string& suite, const std::string& trace) {
        shop.suite(suite + One + trace);
        return shop.check();
    };
    CHECK(status("max_rmse = 9.79\n", "") == 1);
    CHECK(status("max_rmse = 9.80\n", "") == 0);
    CHECK(status("max_rmse = 9.80\n", "max_rmse = 1\n") == 1);
    CHECK(status("", "max_rmse = 10\n") == 0);
    CHECK(status("", "max_rmse = 10\nmax_worst = 96\n") == 0);
    CHECK(status("max_worst = 95\n", "max_rmse = 10\n") == 1);
    CHECK(status("", "frames = '1-3'\n") == 0); // Not the one that differs.
    CHECK(status("", "frames = '0-1'\n") == 1);
}

TEST_CASE("A frame that is wanted and not drawn, and a trace that cannot be read, are errors") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    fs::copy(shop.folder / "wanted/frame_0003.png", shop.folder / "wanted/frame_0009.png");
    CHECK(shop.check() == 1);
    CHECK_THAT(shop.junit(), Contains("tests=\"5\" failures=\"0\" errors=\"1\""));
    shop.suite(std::string(One) + "frames = '0-3'\n");
    CHECK(shop.check() == 0);
    shop.suite("[[trace]]\ninput = 'none.trace'\nreference = 'wanted'\n" + std::string(One));
    CHECK(shop.check() == 1);
    CHECK_THAT(shop.junit(),
               Contains("<testcase classname=\"none\" name=\"replay\">\n      <error"));
}

TEST_CASE("A picture of another size fails") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    write_png(shop.folder / "wanted/frame_0001.png", Image(4, 4));
    CHECK(shop.check() == 1);
    CHECK_THAT(shop.junit(), Contains("is 8x4, the reference 4x4"));
}

TEST_CASE("A suite that is wrong is one line with its place") {
    const auto error = [](const std::string& text) -> std::string {
        const TemporaryFile file(text, ".toml");
        try {
            read_suite(file.path());
        } catch (const InputError& wrong) {
            CHECK_THAT(wrong.what(), StartsWith(file.path()));
            return wrong.what();
        }
        return "no error";
    };
    CHECK_THAT(error(""), Contains("expected a [[trace]]"));
    CHECK_THAT(error("[[trace]]\ninput = 'a'\n"), Contains(":1: a trace needs reference"));
    CHECK_THAT(error("[[trace]]\ninptu = 'a'\n"),
               Contains(":2: unknown key inptu; did you mean "
                        "input?"));
    CHECK_THAT(error("max_rmse = 'x'\n" + std::string(One)),
               Contains(":1: max_rmse: expected a "
                        "number"));
    CHECK_THAT(error(One + std::string("max_rmse = -1\n")),
               Contains(":4: max_rmse: expected a number not below 0"));
    CHECK_THAT(error(One + std::string("samples = 3\n")), Contains("samples: expected 1 or 4"));
    CHECK_THAT(error(One + std::string("name = '../x'\n")), Contains("is not one of a folder"));
    CHECK_THAT(error(One + std::string(One)), Contains("there is a trace clears before"));
    CHECK_THAT(error("[[trace]\n"), Contains(":1"));
    CHECK_THAT(error(One + std::string("frames = '2-x'\n")), Contains(":4: frames 2-x: expected"));
    CHECK_THAT(error(One + std::string("max_rmse = nan\n")), Contains("expected a number"));
    CHECK(run({"check", "/no/such/suite.toml", "-o", "/tmp"}) == 2);
}

TEST_CASE("A suite whose output would be written over references draws nothing") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    const std::string kept = content(shop.folder / "wanted/frame_0000.png");
    fs::create_directory(shop.folder / "out2");
    fs::create_directory_symlink(shop.folder / "wanted", shop.folder / "out2/clears");
    CHECK(run({"check", shop.folder / "suite.toml", "-o", shop.folder / "out2"}) == 2);
    shop.suite(One + std::string("name = 'wanted'\nframes = '1'\n"));
    CHECK(run({"check", shop.folder / "suite.toml", "-o", shop.folder.path()}) == 2);
    CHECK(run({"check", shop.folder / "suite.toml", "-o", shop.folder.path(), "--update"}) == 2);
    CHECK(content(shop.folder / "wanted/frame_0000.png") == kept);
    CHECK_FALSE(fs::exists(shop.folder / "wanted/stats.json"));
}

TEST_CASE("A reference that cannot be looked at is one line, or an error of its frame") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    fs::remove(shop.folder / "wanted/frame_0001.png");
    fs::create_symlink("frame_0001.png", shop.folder / "wanted/frame_0001.png"); // no end
    fs::remove(shop.folder / "wanted/frame_0002.png");
    fs::create_directory(shop.folder / "wanted/frame_0002.png");
    std::ofstream(shop.folder / "wanted/frame_0003.png") << "\x89PNG\r\n";
    CHECK(shop.check() == 1);
    CHECK_THAT(shop.junit(), Contains("tests=\"4\" failures=\"0\" errors=\"3\""));
}

TEST_CASE("Pictures beside a frame in the references are no frames") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    fs::copy(shop.folder / "wanted/frame_0001.png",
             shop.folder / "wanted/frame_0001_difference.png");
    CHECK(shop.check() == 0);
}

TEST_CASE("Frames that a suite asks for and its trace does not have are told of") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    shop.suite(One + std::string("frames = '0-9'\n"));
    int status = -1;
    const std::string said = printed(stderr, [&] { status = shop.check(); });
    CHECK(status == 0);
    CHECK_THAT(said, Contains("ends before frame 4, 9 was asked for"));
}

TEST_CASE("A picture that cannot be written ends a suite with status 2") {
    const Workshop shop;
    shop.suite(One);
    REQUIRE(shop.check({"--update"}) == 0);
    const char* const name = GENERATE("frame_0001.png", "frame_0002_difference.png");
    const std::string changed = shop.folder / "wanted/frame_0002.png";
    Image image = read_image(changed);
    image.rgb[0] ^= 1;
    write_png(changed, image);
    const std::string taken = shop.folder / "out/clears/" + name;
    fs::remove(taken);
    fs::create_directories(taken + "/by a folder");
    const std::string line = printed(stderr, [&] { CHECK(shop.check() == 2); });
    CHECK_THAT(line, Contains(taken + ": cannot be written"));
}

TEST_CASE("A suite that is interrupted reports what it drew, and what it did not") {
    const Workshop shop;
    shop.suite(One + std::string("name = 'first'\n") + One);
    REQUIRE(shop.check({"--update"}) == 0);
    const Suite suite = read_suite(shop.folder / "suite.toml");
    const Interruption interruption;
    CheckOptions options;
    options.output = shop.folder / "stopped";
    options.on_frame = [](const CheckedFrame& frame) {
        if (frame.trace == "first" && frame.name == "frame_0003") std::raise(SIGTERM);
    };
    const std::vector<CheckedFrame> frames = check_suite(suite, options);
    REQUIRE(frames.size() == 5);
    CHECK(frames[3].verdict == Verdict::Passed);
    CHECK(frames[4].trace == "clears");
    CHECK(frames[4].verdict == Verdict::Error);
    CHECK_THAT(frames[4].message, StartsWith("interrupted"));
}

TEST_CASE("A report names files of any name as a page's addresses") {
    CheckedFrame frame;
    frame.trace = "t";
    frame.verdict = Verdict::Failed;
    frame.picture = "a#b?c%20 d\xC3\xA4:e/frame_0000.png";
    CHECK_THAT(html_report("s", {frame}),
               Contains("<img src=\"a%23b%3Fc%2520%20d%C3%A4%3Ae/frame_0000.png\""));
}

TEST_CASE("Reports are XML whatever bytes a name has") {
    CheckedFrame frame;
    frame.name = "frame_0000";
    // RFC 3629: a lone byte, an overlong form, a surrogate, beyond Unicode; XML: no U+FFFE.
    for (const char* const wrong : {"\xFF",
                                    "\x80",
                                    "\xC0\xAF",
                                    "\xE0\x80\x80",
                                    "\xED\xA0\x80",
                                    "\xF4\x90\x80\x80",
                                    "\xEF\xBF\xBE",
                                    "\xEF\xBF\xBF",
                                    "\xC3",
                                    "\xF0\x9F\x98"}) {
        INFO(wrong);
        frame.trace = std::string("a") + wrong;
        CHECK_THAT(junit_report("s", {frame}),
                   Contains("classname=\"a\xEF\xBF\xBD") && !Contains(wrong));
    }
    for (const char* const right :
         {"\xC3\xA4", "\xE6\x97\xA5", "\xF0\x9F\x98\x80", "\xEF\xBF\xBD"}) {
        frame.trace = right;
        CHECK_THAT(junit_report("s", {frame}),
                   Contains("classname=\"" + std::string(right) + "\""));
    }
}

TEST_CASE("What stands in reports cannot break out of them") {
    CheckedFrame frame;
    frame.trace = "a<b>&\"c\"\n";
    frame.name = "frame_0000";
    frame.verdict = Verdict::Error;
    frame.message = "<script>";
    const std::string xml = junit_report("s", {frame}), page = html_report("s", {frame});
    CHECK_THAT(xml, Contains("classname=\"a&lt;b&gt;&amp;&quot;c&quot; \""));
    CHECK_THAT(xml, Contains("message=\"&lt;script&gt;\">&lt;script&gt;</"));
    CHECK_THAT(page, Contains("a&lt;b&gt;&amp;&quot;c&quot;") && !Contains("<script>"));
}

} // namespace
} // namespace ffgpu::tools
