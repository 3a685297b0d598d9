// `ffgpu check`: suites, verdicts, and what is written of them.

#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"
#include "tools/check/reports.h"
#include "tools/image/image.h"

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
                        "message=\"rmse 9.798 (at most 0), worst 96 at (1, 1)\"/>"));
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
    CHECK_THAT(error(One + std::string("max_rmse = -1\n")), Contains(":4: max_rmse: below 0"));
    CHECK_THAT(error(One + std::string("samples = 3\n")), Contains("samples: expected 1 or 4"));
    CHECK_THAT(error(One + std::string("name = '../x'\n")), Contains("is not one of a folder"));
    CHECK_THAT(error(One + std::string(One)), Contains("there is a trace clears before"));
    CHECK_THAT(error("[[trace]\n"), Contains(":1"));
    CHECK(run({"check", "/no/such/suite.toml", "-o", "/tmp"}) == 2);
}

TEST_CASE("What stands in reports cannot break out of them") {
    CheckedFrame frame;
    frame.trace = "a<b>&\"c\"\n";
    frame.name = "frame_0000";
    frame.verdict = Verdict::Error;
    frame.message = "<script>";
    const std::string xml = junit_report("s", {frame}), page = html_report("s", {frame});
    CHECK_THAT(xml, Contains("classname=\"a&lt;b&gt;&amp;&quot;c&quot; \""));
    CHECK_THAT(xml, Contains("message=\"&lt;script&gt;\""));
    CHECK_THAT(page, Contains("a&lt;b&gt;&amp;&quot;c&quot;") && !Contains("<script>"));
}

} // namespace
} // namespace ffgpu::tools
