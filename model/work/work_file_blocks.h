// WorkFileBlocks: the blocks of a work file, one after the other. Every size is compared with what
// is there before memory is taken for it.

#pragma once

#include "model/work/column_bytes.h"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::work {

class WorkFileBlocks {
public:
    // Throws InputError, as all below, where the file is missing, of another kind or version.
    explicit WorkFileBlocks(const std::string& path);

    // Reads the next block. False: it was the last.
    bool next();

    BlockKind kind() const { return static_cast<BlockKind>(header_.kind); }
    std::uint32_t items() const { return header_.items; }
    ColumnReader& columns() { return columns_; }

    // Throws: `what` is wrong with the block that was read last.
    [[noreturn]] void fail(const std::string& what) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void read_bytes(void* to, std::size_t count);
    void unpack(const std::vector<std::uint8_t>& packed);
    void divide();

    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t size_ = 0, at_ = 0, block_at_ = 0; // bytes
    BlockHeader header_;
    std::vector<std::uint8_t> raw_;
    ColumnReader columns_;
};

} // namespace ffgpu::work
