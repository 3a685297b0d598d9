// DrawPreparation: makes a draw or an image ready in two steps. What the machine's command
// processor, geometry and set-up need is known at once: the draw, its primitives, and of each piece
// how many quads it has. The quads and the lines that they touch are most of the work, and can
// follow part by part, while the machine is at those before.

#pragma once

#include "model/work/address_map.h"
#include "model/work/depth_test_masks.h"
#include "model/work/piece_walk.h"
#include "model/work/prepared_work.h"
#include "model/work/target_lookups.h"
#include "model/work/texel_lookups.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ffgpu::work {

class DrawPreparation {
public:
    // Places what the command reads and writes, and appends the draw to the scene: primitive after
    // primitive, piece after piece, whose quads come behind those that the scene has. Command,
    // configuration and map must outlive this; what is placed anew later changes nothing here.
    DrawPreparation(const WholeCommand& command,
                    const WorkConfig& config,
                    AddressMap& addresses,
                    PreparedScene& scene);

    std::size_t quads_left() const { return quads_left_; }

    // Appends the next quads in the traversal order, `most` of them at most, and of the pieces that
    // end with them what is known then.
    void add_quads(std::size_t most, PreparedQuads& out, std::vector<PieceEnd>& ends);

private:
    // What the rasterizer makes: a quad of the command, or some of its lanes. In the order of their
    // keys, then of their numbers, as one number.
    class Ordered {
    public:
        Ordered() = default;
        Ordered(std::uint64_t key, std::uint32_t quad, std::uint8_t lanes)
            : bits_(key << 36 | std::uint64_t{quad} << 4 | lanes) {}

        std::uint32_t key() const { return static_cast<std::uint32_t>(bits_ >> 36); }
        std::uint32_t quad() const { return static_cast<std::uint32_t>(bits_ >> 4); }
        std::uint8_t lanes() const { return bits_ & 0xf; }
        bool operator<(const Ordered& other) const { return bits_ < other.bits_; }

    private:
        std::uint64_t bits_ = 0;
    };

    // One that has quads.
    struct PieceSource {
        std::uint32_t piece = 0;          // of the scene
        std::uint32_t begin = 0, end = 0; // of the command's quads
        PieceBox box;
    };

    struct Places;
    void place(const Registers& state, AddressMap& addresses, PreparedDraw& draw);
    void add_primitives(PreparedScene& scene, PreparedDraw& draw);
    void add_untold_primitives(PreparedScene& scene, PreparedDraw& draw);
    std::size_t add_piece(std::size_t begin,
                          std::uint32_t primitive,
                          std::uint32_t number,
                          PieceBox box,
                          PreparedScene& scene,
                          PreparedDraw& draw);
    std::uint32_t made_of(std::span<const WorkQuad> quads) const;
    void begin_piece(const PieceSource& source);
    void sort_order();
    void order_quads(std::span<const WorkQuad> quads, std::uint32_t number);
    void order_fragments(const WorkQuad& quad, std::uint32_t number);
    void add_quad(std::uint32_t number, std::uint8_t lanes, PreparedQuads& out);
    void
    add_values(std::uint32_t number, std::uint8_t lanes, PreparedQuad& quad, PreparedQuads& out);

    const WholeCommand& command_;
    const WorkConfig& config_;
    const std::uint32_t draw_number_; // of the scene
    const DepthTestPlace test_;
    std::optional<QuadValueKinds> value_kinds_; // where it has values
    TargetLookups targets_;
    TexelLookups texels_;
    std::vector<PieceSource> sources_;
    std::size_t next_source_ = 0;
    std::size_t quads_left_ = 0;
    // Of the piece under way, which is that of the source before the next:
    std::optional<PieceWalk> walk_;
    std::vector<Ordered> order_, spare_order_;
    std::size_t next_in_order_ = 0;
};

} // namespace ffgpu::work
