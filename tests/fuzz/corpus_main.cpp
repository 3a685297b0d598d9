// Plays the files of a corpus, and mutations of them: TARGET FOLDER [MUTATIONS [SEED]]. A target
// that does not come back leaves the input in fuzz_last_input.

#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

using Input = std::vector<std::uint8_t>;
namespace fs = std::filesystem;

Input read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Input> corpus_in(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<Input> corpus;
    for (const fs::path& path : paths)
        corpus.push_back(read(path));
    return corpus;
}

// One to eight changes: a bit, a byte, a number of 32 bits that is on an edge, a piece that is cut
// out, doubled, or taken from another input.
class Mutator {
public:
    Mutator(const std::vector<Input>& corpus, std::uint32_t seed)
        : corpus_(corpus)
        , random_(seed) {}

    Input next() {
        Input input = corpus_[below(corpus_.size())];
        for (std::size_t i = 1 + below(8); i > 0; --i)
            change(input);
        return input;
    }

private:
    std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }
    std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }

    void change(Input& input) {
        if (input.empty()) return input.push_back(byte());
        const std::size_t at = below(input.size());
        const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
        switch (below(6)) {
        case 0:
            input[at] ^= static_cast<std::uint8_t>(1u << below(8));
            return;
        case 1:
            input[at] = byte();
            return;
        case 2: {
            static constexpr std::uint32_t Edges[] = {
                0, 1, 0x7f, 0x80, 0xff, 0x7fff, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff};
            const std::uint32_t edge = Edges[below(std::size(Edges))];
            for (std::size_t i = 0; i < 4 && at + i < input.size(); ++i)
                input[at + i] = static_cast<std::uint8_t>(edge >> 8 * i);
            return;
        }
        case 3:
            input.erase(place, place + static_cast<std::ptrdiff_t>(piece(input, at)));
            return;
        case 4: {
            const Input copy(place, place + static_cast<std::ptrdiff_t>(piece(input, at)));
            input.insert(place, copy.begin(), copy.end());
            return;
        }
        default: {
            const Input& other = corpus_[below(corpus_.size())];
            const std::size_t from = below(other.size());
            const auto first = other.begin() + static_cast<std::ptrdiff_t>(from);
            input.insert(place, first, first + static_cast<std::ptrdiff_t>(piece(other, from)));
        }
        }
    }
    std::size_t piece(const Input& input, std::size_t at) {
        return std::min(input.size() - at, std::size_t{1} << below(8));
    }

    const std::vector<Input>& corpus_;
    std::mt19937 random_;
};

void play(const Input& input) {
    std::ofstream("fuzz_last_input", std::ios::binary)
        .write(reinterpret_cast<const char*>(input.data()),
               static_cast<std::streamsize>(input.size()));
    ffgpu::fuzz::run(input);
}

} // namespace

int main(int count, char** arguments) {
    if (count < 2) {
        std::fprintf(stderr, "usage: %s FOLDER [MUTATIONS [SEED]]\n", arguments[0]);
        return 2;
    }
    if (fs::is_regular_file(arguments[1])) return ffgpu::fuzz::run(read(arguments[1])), 0;
    const std::vector<Input> corpus = corpus_in(arguments[1]);
    if (corpus.empty()) {
        std::fprintf(stderr, "%s: no corpus\n", arguments[1]);
        return 2;
    }
    const unsigned mutations = count > 2 ? static_cast<unsigned>(std::atoi(arguments[2])) : 0;
    Mutator mutator(corpus, count > 3 ? static_cast<unsigned>(std::atoi(arguments[3])) : 1);
    for (const Input& input : corpus)
        play(input);
    for (unsigned i = 0; i < mutations; ++i)
        play(mutator.next());
    fs::remove("fuzz_last_input");
    std::printf("%zu inputs and %u mutations\n", corpus.size(), mutations);
}
