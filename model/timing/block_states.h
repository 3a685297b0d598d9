// BlockStates: what the chip knows of the blocks of depth or colour targets, a block being what a
// line of their cache holds, and so what a line costs on its way from and to memory:
//
//   plain        as it is
//   cleared      not in memory at all: every pixel is the target's clear value
//   compressed   a code of model/work/block_code.h, in whole bursts
//
// It follows the targets' real contents in the order of the machine, and checks its own claims
// against them: that a cleared block is of the clear value, that a code decodes to the block.
// After S. Morein, ATI Radeon HyperZ Technology, Hot3D at Graphics Hardware 2000.

#pragma once

#include "model/timing/block_statistics.h"
#include "model/timing/config/blocks.h"
#include "model/timing/hierarchical_depth.h"
#include "model/timing/line_store.h"
#include "model/work/machine_order.h"
#include "model/work/surface_contents.h"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace ffgpu::timing {

enum class BlockState : std::uint8_t { Plain, Cleared, Compressed };

class BlockStates final : public LineStore {
public:
    struct Shape {
        std::uint32_t line_bytes = 64;
        std::uint32_t transfer_bytes = 4; // pieces of a masked write
        std::uint32_t burst_bytes = 16;   // of the memory: codes are as many as they need
    };

    // `coarse`: told of what happens to depths; null: nobody.
    BlockStates(std::string_view name,
                const BlockConfig& config,
                const Shape& shape,
                HierarchicalDepth* coarse);

    std::uint32_t stored_bytes(std::uint64_t number) const override;
    void fetched(std::uint64_t number, work::LineMask dirty) override;
    LineWrite write_back(const LeavingLine& line) override;

    // A quad's values, as far as they lie in line `number`, which its unit looked up.
    // `stencil`: stencil values may be among them.
    void write(const work::PlacedLevel& place,
               const work::PreparedQuad& quad,
               const SampleWords& values,
               std::uint64_t number,
               bool stencil = false);

    // By the command processor, while nothing is under way. A clear begins, asks line after line
    // whether its state can say it all, and ends when memory and caches are as it leaves them.
    void content(const work::PreparedContent& content);
    void begin_clear(const work::PreparedTransfer& transfer);
    bool clear_fast(const work::TransferLine& line);
    void end_clear(const work::PreparedTransfer& transfer);

    // Something writes the line in memory. True: it was not plain, and some of it stays, so that
    // it has to be read (stored_bytes, before) and written whole.
    enum class Change : std::uint8_t { Part, Whole };
    bool make_plain(std::uint64_t number, Change change);
    // It writes other than what quads and clears do.
    void forget(std::uint64_t number);

    std::uint64_t clear_cycles(std::uint64_t blocks) const {
        return (blocks + config_.clears_per_cycle - 1) / config_.clears_per_cycle;
    }
    BlockState state(std::uint64_t number) const;
    const work::SurfaceContents& contents() const { return contents_; }
    const StatisticsGroup& statistics() const { return statistics_; }

private:
    struct Block {
        BlockState state = BlockState::Plain;
        bool stencil_cleared = false; // Its stencil values are the target's clear value's.
        std::uint32_t bytes = 0;      // compressed: in memory
    };
    struct Target {
        work::PlacedLevel place;
        Format format = Format::None;
        std::uint64_t first_line = 0;
        std::vector<Block> blocks; // those whose states the chip keeps
        std::uint32_t clear_word = 0;
        std::uint64_t cleared = 0; // blocks
        // While it is cleared:
        bool fast = false;           // states may say it
        bool keeps_stencil = false;  // where the stencil values are known
        bool writes_stencil = false; // some bits of them
    };

    Target* target_of(std::uint64_t number);
    const Block* find(std::uint64_t number) const;
    Block* find(std::uint64_t number);
    void add_target(const work::PreparedContent& content);
    void plan_clear(const work::PreparedTransfer& transfer,
                    const work::SurfaceFill& fill,
                    Target& target);
    bool takes_state(const Target& target, const work::TransferLine& line);
    void set_state(Target& target, Block& block, BlockState state);
    std::uint32_t code_bytes(std::uint64_t number) const;
    void check_cleared(const Target& target, std::uint64_t number, work::LineMask dirty) const;

    const BlockConfig config_;
    const Shape shape_;
    const work::LineGrain grain_;
    HierarchicalDepth* const coarse_;
    work::SurfaceContents contents_;
    std::map<std::uint64_t, Target> targets_; // by first line
    std::uint64_t kept_ = 0;                  // blocks with states
    BlockStatistics statistics_;
};

} // namespace ffgpu::timing
