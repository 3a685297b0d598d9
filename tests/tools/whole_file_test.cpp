// Files are there whole or not at all, whatever happens to the disk.

#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "tests/support/file_size_limit.h"
#include "tests/tools/tool.h"
#include "tools/image/image.h"
#include "tools/image/image_writer.h"
#include "tools/image/png_file.h"
#include "tools/replay/interruption.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

struct Folder {
    fs::path path = fs::temp_directory_path() / ("ffgpu_whole_" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

// Bytes that do not compress.
Image noise(unsigned size) {
    Image image(size, size);
    std::uint32_t state = 1;
    for (std::uint8_t& value : image.rgb) {
        state = state * 1664525u + 1013904223u;
        value = static_cast<std::uint8_t>(state >> 24);
    }
    return image;
}

} // namespace

TEST_CASE("A file's name may be as long as names can be, beside one that begins alike") {
    const Folder folder;
    const fs::path one = folder.path / (std::string(254, 'x') + '1');
    const fs::path other = folder.path / (std::string(254, 'x') + '2');
    WholeFile first(one), second(other);
    first.write("first");
    second.write("second");
    CHECK(folder.files() == 2);
    first.commit();
    second.commit();
    CHECK(folder.files() == 2);
    CHECK(fs::file_size(one) == 5);
    CHECK(fs::file_size(other) == 6);
}

TEST_CASE("a picture that finds no room leaves the older one, and nothing else") {
    const Folder folder;
    const std::string path = (folder.path / "a.png").string();
    write_png(path, noise(8));
    {
        const FileSizeLimit limit(4096);
        CHECK_THROWS_WITH(write_png(path, noise(64)), Contains(path + ": cannot be written"));
    }
    CHECK(folder.files() == 1);
    CHECK(read_png(path).rgb == noise(8).rgb);
    write_png(path, noise(64));
    CHECK(read_png(path).rgb == noise(64).rgb);
}

TEST_CASE("a file that is not committed was never there") {
    const Folder folder;
    const std::string path = (folder.path / "text").string();
    { WholeFile(path).write("lost"); }
    CHECK(folder.files() == 0);
    WholeFile file(path);
    file.write("kept");
    CHECK_FALSE(fs::exists(path));
    file.commit();
    CHECK(fs::file_size(path) == 4);
}

TEST_CASE("a file that was not written whole does not get its name") {
    const Folder folder;
    WholeFile file((folder.path / "text").string());
    {
        const FileSizeLimit limit(4096);
        CHECK_THROWS_WITH(file.write(std::string(10'000, 'x')), Contains("File too large"));
    }
    CHECK_THROWS_WITH(file.write("the rest"), Contains("File too large"));
    CHECK_THROWS_WITH(file.commit(), Contains("File too large"));
    CHECK(folder.files() == 0);
}

TEST_CASE("what is no plain file is written as it is") {
    const Folder folder;
    const std::string path = (folder.path / "pipe").string();
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
    {
        WholeFile file(path);
        file.write("text");
        file.commit();
    }
    std::array<char, 8> text{};
    CHECK(::read(reader, text.data(), text.size()) == 4);
    ::close(reader);
    CHECK(fs::is_fifo(path));
    CHECK(folder.files() == 1);
}

TEST_CASE("a link stays one: what it leads to is written") {
    const Folder folder;
    const fs::path link = folder.path / "link", target = folder.path / "target";
    { std::ofstream(target) << "before"; }
    fs::create_symlink(target, link);
    WholeFile file(link.string());
    file.write("text");
    file.commit();
    CHECK(fs::is_symlink(link));
    CHECK(fs::file_size(target) == 4);
}

TEST_CASE("a forked child leaves its parent's file alone") {
    const Folder folder;
    const fs::path path = folder.path / "text";
    std::optional<WholeFile> file(path.string());
    file->write("parent");
    const pid_t child = ::fork();
    if (child == 0) {
        file->write("child");
        file.reset();
        std::_Exit(EXIT_SUCCESS);
    }
    ::waitpid(child, nullptr, 0);
    file->commit();
    CHECK(fs::file_size(path) == 6);
}

TEST_CASE("who ends the process at once takes its unfinished files away, and no one else's") {
    const Folder folder;
    const std::string kept = (folder.path / "kept").string();
    WholeFile of_parent(kept);
    of_parent.write("parent");
    const pid_t child = ::fork();
    if (child == 0) {
        // More than are remembered at a time, each over before the next.
        for (int i = 0; i < 100; ++i)
            WholeFile((folder.path / "brief").string()).write("over");
        WholeFile first((folder.path / "first").string()),
            second((folder.path / "second").string());
        first.write("a");
        first.commit();
        second.write("b");
        UnfinishedFile::remove_all();
        std::_Exit(EXIT_SUCCESS);
    }
    ::waitpid(child, nullptr, 0);
    CHECK(folder.files() == 2); // "first", and the parent's
    CHECK(fs::exists(folder.path / "first"));
    of_parent.commit();
    CHECK(fs::file_size(kept) == 6);
}

TEST_CASE("a second Ctrl-C ends at once, and leaves no half of a file") {
    const Folder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        const Interruption interruption;
        WholeFile file((folder.path / "text").string());
        file.write("half");
        std::raise(SIGINT);
        ::usleep(600'000); // Sooner it is the same one.
        std::raise(SIGINT);
        std::_Exit(EXIT_SUCCESS);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGINT);
    CHECK(folder.files() == 0);
}

TEST_CASE("behind a picture that cannot be written none is") {
    const Folder folder;
    ImageWriter writer;
    for (const char* const name : {"a.png", "none/b.png", "c.png", "d.png"}) {
        try {
            writer.add((folder.path / name).string(), noise(8));
        } catch (const InputError&) {
        }
    }
    CHECK_THROWS_WITH(writer.finish(), Contains("none/b.png: cannot be written"));
    CHECK_THROWS_AS(writer.add((folder.path / "e.png").string(), noise(8)), InputError);
    CHECK(fs::exists(folder.path / "a.png"));
    CHECK(folder.files() == 1);
}

TEST_CASE("what cannot be written in the middle of a frame ends the replay of a trace") {
    const Folder folder;
    const std::string trace = FFGPU_SOURCE_DIR "/traces/corridor.trace";
    const auto replay = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"replay", trace, "--frames", "0-0"};
        words.insert(words.end(), more.begin(), more.end());
        return printed(stderr, [&] {
            const FileSizeLimit limit(4096);
            CHECK(run(words) == 2);
        });
    };
    const std::string capture = (folder.path / "all.ffc").string();
    CHECK_THAT(replay({"--capture", capture}), Contains(capture + ": cannot be written"));
    const std::string out = (folder.path / "out").string();
    CHECK_THAT(replay({"--steps", "1", "-o", out}),
               StartsWith("ffgpu: " + out) && Contains(".png: cannot be written"));
    CHECK(folder.files() == 1); // the folder itself
}

TEST_CASE("a file in a folder that is not there is an error with its name") {
    CHECK_THROWS_WITH(WholeFile("/no/such/folder/x"),
                      Contains("/no/such/folder/x: cannot be written: No such file"));
}

TEST_CASE("a damaged PNG is an error, not a picture") {
    const Folder folder;
    const std::string path = (folder.path / "cut.png").string();
    write_png(path, noise(64));
    fs::resize_file(path, fs::file_size(path) / 2);
    CHECK_THROWS_WITH(read_image(path), Contains(path + ": is a damaged PNG"));
}

} // namespace ffgpu::tools
