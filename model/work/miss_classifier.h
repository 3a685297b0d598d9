// MissClassifier: Hill's three kinds of miss. Compulsory: the first look-up of the line since it
// was last thrown out from outside (a flush, a discarded range), or ever. Capacity: a fully
// associative cache of the same size with LRU replacement, the shadow, would miss, too. Conflict:
// the rest. (M. D. Hill, Aspects of Cache Memory and Instruction Buffer Performance, 1987)
//
// The shadow goes through all that the cache goes through, flushes and discards included, so that
// with LRU replacement and one set it holds the cache's very lines and no miss is a conflict. With
// one set and another replacement a miss where the shadow hits is counted as capacity: there is no
// placement that it could conflict with. With several sets it is a conflict whatever chose the
// victim. Hits where the shadow misses are told, too: Hill's difference between the misses of the
// cache and of the shadow is conflicts minus those, and may be negative.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

enum class MissKind : std::uint8_t { Compulsory, Capacity, Conflict };

class MissClassifier {
public:
    MissClassifier(std::uint32_t sets, std::uint32_t ways);

    // Every look-up goes through here, hit or miss; the result says what it is if it was a miss.
    MissKind access(std::uint64_t line);

    // The same of a line that is then kept beside the shadow's list, in one of its first places:
    // what is looked up again and again need not be moved in the list, nor told, as long as it is
    // among the last that were. What was in the place before is the most recently used of the list
    // now. Of a shadow with a line for each place; all look-ups go this way then.
    static constexpr std::size_t FirstPlaces = 4;
    MissKind access_first(std::uint64_t line, std::size_t place);
    // Of a miss where the shadow hits, which all lines of the first places do.
    MissKind kind_beside_shadow() const {
        return fully_associative_ ? MissKind::Capacity : MissKind::Conflict;
    }
    std::size_t capacity() const { return capacity_; }

    // The shadow missed at the last access.
    bool shadow_missed() const { return shadow_missed_; }

    // The cache lost all its lines, or one, other than by replacement.
    void flush();
    void drop(std::uint64_t line);

private:
    static constexpr std::uint64_t NoPage = ~std::uint64_t{0};
    static constexpr std::uint32_t Nowhere = ~0u;       // touched, but not in the shadow
    static constexpr std::uint32_t Untouched = ~0u - 1; // or dropped, as if never touched

    // Lines side by side, which are often touched one after the other: the node of each.
    static constexpr std::uint64_t PageLines = 16;
    struct Page {
        std::uint64_t number = NoPage;
        std::array<std::uint32_t, PageLines> nodes{};
    };
    // Of the shadow's list, most recently used first; a ring through node 0, which holds no line.
    struct Node {
        std::uint64_t line = 0;
        std::uint32_t before = 0, after = 0;
    };

    std::uint32_t& node_of(std::uint64_t line);
    std::size_t place_of(std::uint64_t page) const;
    void grow();
    MissKind find_or_take(std::uint64_t line, std::uint32_t& node);
    void unlink(std::uint32_t node);
    void link_first(std::uint32_t node);
    std::uint32_t take_node();

    std::size_t capacity_;
    bool fully_associative_;
    bool shadow_missed_ = false;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> free_nodes_;
    std::array<std::uint32_t, FirstPlaces> first_{}; // their nodes, which are in no list; 0: none
    // Open addressing; pages are added and never taken out but all at once.
    std::vector<Page> pages_;
    std::size_t page_count_ = 0;
};

} // namespace ffgpu::work
