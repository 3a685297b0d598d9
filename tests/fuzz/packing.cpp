#include "tests/fuzz/packing.h"

#include "driver/trace/reader/container.h"
#include "model/base/input_error.h"
#include "model/capture/capture_format.h"
#include "model/capture/chunk_file.h"
#include "model/capture/description_text.h"
#include "model/device/description.h"
#include "model/work/work_file_format.h"
#include "model/work/work_file_writer.h"
#include "tests/support/temporary_file.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

#include <snappy.h>
#include <zstd.h>

namespace ffgpu::fuzz {
namespace {

using Buffer = std::vector<std::uint8_t>;

void append(Buffer& to, Bytes bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

template <class Number>
void append_number(Buffer& to, Number value) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&value);
    to.insert(to.end(), bytes, bytes + sizeof value);
}

// Takes from the front, as much as is there.
class Cutter {
public:
    explicit Cutter(Bytes bytes)
        : left_(bytes) {}

    bool empty() const { return left_.empty(); }
    Bytes take(std::size_t count) {
        const Bytes taken = left_.first(std::min(count, left_.size()));
        left_ = left_.subspan(taken.size());
        return taken;
    }
    Bytes rest() { return take(left_.size()); }
    template <class Number>
    Number number() {
        Number value = 0;
        const Bytes bytes = take(sizeof value);
        std::memcpy(&value, bytes.data(), bytes.size());
        return value;
    }

private:
    Bytes left_;
};

Buffer compressed(Bytes content) {
    static ZSTD_CCtx* const context = [] {
        ZSTD_CCtx* const made = ZSTD_createCCtx();
        ZSTD_CCtx_setParameter(made, ZSTD_c_compressionLevel, -5);
        ZSTD_CCtx_setParameter(made, ZSTD_c_checksumFlag, 1);
        return made;
    }();
    Buffer packed(ZSTD_compressBound(content.size()));
    packed.resize(
        ZSTD_compress2(context, packed.data(), packed.size(), content.data(), content.size()));
    return packed;
}

Buffer content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void add_chunk(Buffer& file, Bytes content) {
    const Buffer packed = compressed(content);
    append_number(file, static_cast<std::uint32_t>(content.size()));
    append_number(file, static_cast<std::uint32_t>(packed.size()));
    append(file, packed);
}

// The chunk of this program's own contract.
const Buffer& own_contract() {
    static const Buffer chunk = [] {
        const std::string text = capture::description_text(describe_contract());
        Buffer file;
        add_chunk(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        return file;
    }();
    return chunk;
}

void add_block(Buffer& file, work::BlockHeader header, Bytes content) {
    const Buffer packed = compressed(content);
    header.raw_bytes = static_cast<std::uint32_t>(content.size());
    header.packed_bytes = static_cast<std::uint32_t>(packed.size());
    append_number(file, header);
    append(file, packed);
}

struct Block {
    work::BlockHeader header;
    Buffer content;
};

// The magic and the version, and the blocks behind them.
constexpr std::size_t WorkHeaderBytes = work::WorkFileMagic.size() + 4;

std::vector<Block> blocks_of(const Buffer& file) {
    Cutter cutter(file);
    cutter.take(WorkHeaderBytes);
    std::vector<Block> blocks;
    while (!cutter.empty()) {
        Block block;
        const Bytes header = cutter.take(sizeof block.header);
        std::memcpy(&block.header, header.data(), header.size());
        const Bytes packed = cutter.take(block.header.packed_bytes);
        block.content.resize(block.header.raw_bytes);
        ZSTD_decompress(block.content.data(), block.content.size(), packed.data(), packed.size());
        blocks.push_back(std::move(block));
    }
    return blocks;
}

// What this program writes into a file without commands.
const std::vector<Block>& own_blocks() {
    static const std::vector<Block> blocks = [] {
        const TemporaryFile file("", ".ffw");
        work::WorkFileWriter writer(file.path());
        writer.finish();
        return blocks_of(content_of(file.path()));
    }();
    return blocks;
}

constexpr auto Names = static_cast<std::uint8_t>(work::BlockKind::Names);

} // namespace

std::vector<std::uint8_t> pack_trace(Bytes input) {
    std::string packed;
    snappy::Compress(reinterpret_cast<const char*>(input.data()), input.size(), &packed);
    Buffer file;
    append_number(file, std::uint16_t{'a' | 't' << 8});
    append_number(file, static_cast<std::uint32_t>(packed.size()));
    file.insert(file.end(), packed.begin(), packed.end());
    return file;
}

std::vector<std::uint8_t> unpack_trace(const std::string& path) {
    const auto container = trace::open_container(path);
    Buffer input;
    for (std::vector<std::byte> chunk; container->next(chunk);)
        append(input, {reinterpret_cast<const std::uint8_t*>(chunk.data()), chunk.size()});
    return input;
}

std::vector<std::uint8_t> pack_capture(Bytes input) {
    Cutter cutter(input);
    Buffer file;
    append(file, cutter.take(capture::HeaderBytes));
    const auto contract_bytes = cutter.number<std::uint32_t>();
    if (contract_bytes == 0)
        append(file, own_contract());
    else
        add_chunk(file, cutter.take(contract_bytes));
    while (!cutter.empty())
        add_chunk(file, cutter.take(capture::ChunkBytes));
    append_number(file, std::uint64_t{0});
    return file;
}

std::vector<std::uint8_t> unpack_capture(const std::string& path) {
    capture::ChunkReader reader(path);
    std::array<std::byte, capture::HeaderBytes> header{};
    reader.read_plain(header);
    Buffer input;
    append(input, {reinterpret_cast<const std::uint8_t*>(header.data()), header.size()});
    append_number(input, std::uint32_t{0});
    for (bool is_contract = true; reader.next_chunk(capture::MaxChunkBytes); is_contract = false) {
        const auto chunk = reader.take(reader.left());
        if (!is_contract)
            append(input, {reinterpret_cast<const std::uint8_t*>(chunk.data()), chunk.size()});
    }
    return input;
}

std::vector<std::uint8_t> pack_work_file(Bytes input) {
    Cutter cutter(input);
    Buffer file;
    append(file, cutter.take(WorkHeaderBytes));
    while (!cutter.empty()) {
        const auto kind = cutter.number<std::uint8_t>();
        const auto items = cutter.number<std::uint32_t>();
        const Bytes content = cutter.take(cutter.number<std::uint32_t>());
        const Block& own = own_blocks().front();
        if (kind == Names && content.empty())
            add_block(file, own.header, own.content);
        else
            add_block(file, {.kind = kind, .items = items}, content);
    }
    return file;
}

std::vector<std::uint8_t> unpack_work_file(const std::string& path) {
    const Buffer file = content_of(path);
    if (file.size() < WorkHeaderBytes) throw InputError(path + ": is no work file");
    Buffer input(file.begin(), file.begin() + WorkHeaderBytes);
    for (const Block& block : blocks_of(file)) {
        const bool is_own = block.header.kind == Names;
        append_number(input, static_cast<std::uint8_t>(block.header.kind));
        append_number(input, block.header.items);
        append_number(input, is_own ? 0 : block.header.raw_bytes);
        if (!is_own) append(input, block.content);
    }
    return input;
}

} // namespace ffgpu::fuzz
